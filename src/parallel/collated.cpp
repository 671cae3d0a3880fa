#include "parallel/collated.hpp"
#include "parallel/reduce.hpp"

namespace sph
{

namespace
{
void writeTo(const OutputFile::Taker& taker, const std::function<void(OutputFile&)>& part)
{
    OutputFile file(taker);
    part(file);
    file.close();
}

std::size_t lengthOf(const std::function<void(OutputFile&)>& part)
{
    std::size_t length = 0;
    allOrNone([&] { writeTo([&](std::string_view piece) { length += piece.size(); }, part); });
    return length;
}

/// Acts, and puts the file's name in front of the reason of a failure.
void named(const std::filesystem::path& path, const auto& act)
{
    try
    {
        act();
    }
    catch (const std::runtime_error& e)
    {
        throw CaseError({path.string(), 0}, std::string("cannot be written: ") + e.what());
    }
}
}

void writeCollated(const std::filesystem::path& path, const std::function<void(OutputFile&)>& part, std::optional<std::size_t> length)
{
    const auto* const all = ranks();
    if (!all)
    {
        OutputFile file(path);
        part(file);
        return file.close();
    }
    // Text is made twice, so that no rank holds it: 740 MB that 2 ranks held and wrote in one call each took 3 to 10 times as long as in calls of 1 MB, for
    // memory that is new costs more than the disk's cache.
    std::size_t at = sumOfRanksBefore(length ? *length : lengthOf(part));
    std::unique_ptr<Ranks::SharedFile> file;
    named(path, [&] { file = all->create(path); });
    const auto write = [&](std::string_view piece)
    {
        named(path, [&] { file->write(at, piece); });
        at += piece.size();
    };
    allOrNone([&] { writeTo(write, part); });
    allOrNone([&] { named(path, [&] { file->close(); }); });
}

}
