#include "case/FieldFile.hpp"
#include "base/words.hpp"
#include "case/FoamHeader.hpp"
#include "case/FoamScanner.hpp"
#include "case/MappedFile.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace sph
{

namespace
{

FieldClass fieldClass(const FoamHeader& header, const std::string& field, std::optional<FieldClass> wanted)
{
    static const std::vector<std::string> known{"labelField", "scalarField", "vectorField", "symmTensorField", "tensorField"};
    const auto at = std::find(known.begin(), known.end(), header.className);
    if (at == known.end())
        throw ScanError(header.classLine, fmt::format("class \"{}\" is not a field of a cloud. {}", header.className,
                                                      suggestion(header.className, "classes", known)));
    const auto found = FieldClass(at - known.begin());
    if (wanted && found != *wanted)
        throw ScanError(header.classLine,
                        fmt::format("class \"{}\" is not that of the field {}, {}", header.className, field, known[std::size_t(*wanted)]));
    return found;
}

/// Reads `N ( value ... )`, `N { value }` or `( value ... )`, and sees to it that nothing follows.
class ListReader
{
    FoamScanner& in_;
    const FoamHeader& header_;
    const Slice& slice_;
    std::vector<std::vector<double>*> values_; ///< one array per component, of the slice
    bool hasCount_ = false;
    std::size_t count_ = 0;

public:
    ListReader(FoamScanner& in, const FoamHeader& header, const Slice& slice, std::vector<std::vector<double>*> values)
        : in_(in), header_(header), slice_(slice), values_(std::move(values))
    {
        std::int64_t count = 0;
        if (in_.peek() == '(' && !header.binary) return;
        if (!in_.integer(count) || count < 0) in_.fail("expected the number of values, found " + in_.found());
        hasCount_ = true;
        count_ = std::size_t(count);
    }

    void expect(std::size_t n, const std::string& field) const
    {
        if (hasCount_ && count_ != n) in_.fail(fmt::format("field {} has {} values, positions has {}", field, count_, n));
    }
    std::size_t count() const { return count_; }

    /// `append(i)` reads value i and appends it to the arrays; all of it, or throws. `bytes`: of one value in binary; `pass(begin, end)` goes past
    /// some. Returns how many there are.
    std::size_t read(std::size_t bytes, const auto& append, const auto& pass)
    {
        const auto n = header_.binary ? readBinary(bytes, append, pass) : readAscii(append);
        if (in_.peek() != '\0' || !in_.atEnd()) in_.fail(fmt::format("unexpected {} after the list", in_.found()));
        return n;
    }
    void dropLast()
    {
        for (auto* a : values_) a->pop_back();
    }

private:
    void reserve(std::size_t n)
    {
        for (auto* a : values_) a->reserve(n);
    }

    std::size_t readBinary(std::size_t bytes, const auto& append, const auto& pass)
    {
        // OpenFOAM writes an empty list as its count alone.
        if (count_ == 0 && in_.peek() == '\0') return 0;
        if (in_.peek() == '{') in_.fail("a compact list N{value} cannot be in a binary file");
        if (!in_.take('(')) in_.fail("expected ( and the values, found " + in_.found());
        in_.enterBinary();
        if (count_ > in_.remaining() / bytes)
            in_.fail(fmt::format("the file is truncated: {} values need {:.0f} bytes, {} are there", count_, double(count_) * double(bytes),
                                 in_.remaining()));
        const auto begin = slice_.begin(count_), end = slice_.end(count_);
        reserve(end - begin);
        pass(0, begin);
        for (std::size_t i = begin; i < end; ++i) append(i);
        pass(end, count_);
        if (!in_.takeHere(')')) in_.fail(fmt::format("expected ) right after {} values, found {}", count_, in_.found()));
        return count_;
    }

    std::size_t readAscii(const auto& append)
    {
        // A list that does not state its length has its slice cut at its end.
        const auto begin = hasCount_ ? slice_.begin(count_) : 0,
                   end = hasCount_ ? slice_.end(count_) : std::numeric_limits<std::size_t>::max();
        if (hasCount_ && in_.take('{'))
        {
            append(0);
            if (!in_.take('}')) in_.fail("expected } after the value, found " + in_.found());
            for (auto* a : values_) a->assign(end - begin, double((*a)[0]));
            return count_;
        }
        if (!in_.take('(')) in_.fail("expected ( and the values, found " + in_.found());
        // A value takes two characters at least: a wrong count must not ask for memory that no file of this size can fill.
        reserve(hasCount_ ? std::min(end - begin, in_.remaining() / 2) + 1 : 0);
        std::size_t i = 0;
        for (; !in_.take(')'); ++i)
        {
            if (in_.atEnd()) in_.fail(fmt::format("the file is truncated: it ends after {}", progress(i)));
            if (hasCount_ && i == count_) in_.fail(fmt::format("expected ) after {} values, found {}", count_, in_.found()));
            append(i);
            if (i < begin || i >= end) dropLast();
        }
        if (hasCount_ && i < count_) in_.fail(fmt::format("the list ends after {}", progress(i)));
        if (!hasCount_)
            for (auto* a : values_) *a = {a->begin() + long(slice_.begin(i)), a->begin() + long(slice_.end(i))};
        return i;
    }

    std::string progress(std::size_t i) const
    {
        return hasCount_ ? fmt::format("{} of {} values", i, count_) : fmt::format("{} values", i);
    }
};

double finite(FoamScanner& in, double value, std::size_t i)
{
    if (!std::isfinite(value)) in.fail(fmt::format("the value of particle {} is not finite: {}", i, value));
    return value;
}

double asciiNumber(FoamScanner& in, std::size_t i)
{
    double value;
    if (in.number(value)) return finite(in, value, i);
    if (in.atEnd()) in.fail(fmt::format("the file is truncated in the value of particle {}", i));
    in.fail(fmt::format("expected a number for particle {}, found {}", i, in.found()));
}

double asciiLabel(FoamScanner& in, std::size_t i)
{
    auto start = in;
    std::int64_t value;
    if (in.integer(value)) return double(value);
    if (start.peek() == '\0' && start.atEnd()) start.fail(fmt::format("the file is truncated in the value of particle {}", i));
    start.fail(fmt::format("expected an integer for particle {}, found {}", i, start.found()));
}

void bracket(FoamScanner& in, char c, std::size_t i, int components)
{
    if (in.take(c)) return;
    if (in.atEnd()) in.fail(fmt::format("the file is truncated in the value of particle {}", i));
    in.fail(fmt::format("expected \"{}\" of the {} numbers of particle {}, found {}", c, components, i, in.found()));
}

double binaryNumber(FoamScanner& in, int bits, std::size_t i)
{
    return finite(in, bits == 64 ? in.raw<double>() : double(in.raw<float>()), i);
}

double binaryLabel(FoamScanner& in, int bits) { return bits == 64 ? double(in.raw<std::int64_t>()) : double(in.raw<std::int32_t>()); }

CloudField parseField(std::string_view text, const std::string& name, std::size_t expected, std::optional<FieldClass> wanted,
                      const Slice& slice)
{
    FoamScanner in(text);
    const auto header = readFoamHeader(in);
    CloudField field;
    field.type = fieldClass(header, name, wanted);
    const int components = componentsOf(field.type);
    const bool isLabel = field.type == FieldClass::label;
    field.component.resize(std::size_t(components));

    std::vector<std::vector<double>*> arrays;
    for (auto& values : field.component) arrays.push_back(&values);
    ListReader list(in, header, slice, arrays);
    list.expect(expected, name);
    const auto append = [&](std::size_t i)
    {
        if (!header.binary && components > 1) bracket(in, '(', i, components);
        for (auto& values : field.component)
            values.push_back(header.binary ? (isLabel ? binaryLabel(in, header.labelBits) : binaryNumber(in, header.scalarBits, i))
                                           : (isLabel ? asciiLabel(in, i) : asciiNumber(in, i)));
        if (!header.binary && components > 1) bracket(in, ')', i, components);
    };
    const auto bytes = std::size_t(isLabel ? header.labelBits : components * header.scalarBits) / 8;
    const auto n = list.read(bytes, append, [&](std::size_t begin, std::size_t end) { in.advance((end - begin) * bytes); });
    if (n != expected) in.fail(fmt::format("field {} has {} values, positions has {}", name, n, expected));
    return field;
}

/// Distance of n records from one another, of which the first begins here and the last ends before the closing parenthesis of the file; 0 where they are not
/// even, for white space may stand between them.
std::size_t evenDistance(FoamScanner in, std::size_t bytes, std::size_t n)
{
    auto end = in;
    if (in.remaining() < bytes) return 0;
    in.advance(bytes);
    in.skip();
    const auto distance = std::size_t(in.here() - end.here());
    if (in.atEnd() || (in.remaining() - 1) / distance < n - 1) return 0;
    end.advance(n * distance);
    return end.takeHere(')') && end.peek() == '\0' && end.atEnd() ? distance : 0;
}

Positions parsePositions(std::string_view text, const Slice& slice)
{
    FoamScanner in(text);
    const auto header = readFoamHeader(in);
    if (header.className != "Cloud" && !header.className.starts_with("Cloud<"))
        throw ScanError(header.classLine, fmt::format("class \"{}\" is not that of positions, Cloud<...>", header.className));
    Positions p;
    ListReader list(in, header, slice, {&p.x, &p.y, &p.z});
    if (!header.binary && in.peek() == '{') in.fail("positions cannot be a compact list");
    const auto ascii = [&](std::size_t i)
    {
        bracket(in, '(', i, 3);
        for (auto* values : {&p.x, &p.y, &p.z}) values->push_back(asciiNumber(in, i));
        bracket(in, ')', i, 3);
        std::int64_t cell;
        if (!in.integer(cell)) in.fail(fmt::format("expected the cell label after the position of particle {}, found {}", i, in.found()));
    };
    const auto bytes = std::size_t(3 * header.scalarBits + header.labelBits) / 8 + 2;
    const auto binary = [&](std::size_t i)
    {
        if (!in.take('(')) in.fail(fmt::format("expected ( before the position of particle {}, found {}", i, in.found()));
        if (in.remaining() < bytes - 2) in.fail(fmt::format("the file is truncated in the position of particle {}", i));
        for (auto* values : {&p.x, &p.y, &p.z}) values->push_back(binaryNumber(in, header.scalarBits, i));
        binaryLabel(in, header.labelBits);
        if (!in.takeHere(')')) in.fail(fmt::format("expected ) right after the position of particle {}", i));
        in.skip();
    };
    const auto pass = [&](std::size_t begin, std::size_t end)
    {
        if (begin == end) return;
        in.skip();
        if (const auto distance = evenDistance(in, bytes, list.count() - begin); distance > 0) return in.advance((end - begin) * distance);
        for (std::size_t i = begin; i < end; ++i)
        {
            binary(i);
            list.dropLast();
        }
    };
    p.count = list.read(
        bytes, [&](std::size_t i) { header.binary ? binary(i) : ascii(i); }, pass);
    return p;
}

template<class Result>
std::optional<Result> guarded(const std::filesystem::path& caseFolder, const std::string& file, Diagnostics& diagnostics, const auto& parse)
{
    try
    {
        const MappedFile mapped(caseFolder / file);
        return parse(mapped.text());
    }
    catch (const ScanError& e)
    {
        diagnostics.error({file, e.line}, e.what());
    }
    catch (const std::runtime_error& e)
    {
        diagnostics.error({file, 0}, std::string("cannot be read: ") + e.what());
    }
    return std::nullopt;
}

}

std::optional<Positions> readPositions(const std::filesystem::path& caseFolder, const std::string& file, Diagnostics& diagnostics,
                                       const Slice& slice)
{
    return guarded<Positions>(caseFolder, file, diagnostics, [&](std::string_view text) { return parsePositions(text, slice); });
}

std::optional<CloudField> readField(const std::filesystem::path& caseFolder, const std::string& file, std::size_t expected,
                                    std::optional<FieldClass> wanted, Diagnostics& diagnostics, const Slice& slice)
{
    const auto name = std::filesystem::path(file).filename().string();
    return guarded<CloudField>(caseFolder, file, diagnostics,
                               [&](std::string_view text) { return parseField(text, name, expected, wanted, slice); });
}

}
