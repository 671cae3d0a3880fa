/// Lines, words and numbers of the text of a mesh. For the sources of this module alone.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sph
{

struct NumberedMesh;
template<int dim, class Real> struct Vector;

/// Lines of a text, which end with \n, \r\n or \r, counted from 1.
class TextLines
{
    std::string_view rest_;
    std::size_t number_ = 0;

public:
    /// A byte-order mark of UTF-8 is skipped; throws UnusableMesh where that of UTF-16 stands.
    /// `before`: lines of the file that stand before the text.
    explicit TextLines(std::string_view text, std::size_t before = 0);
    /// Takes the next one; false at the end.
    bool next(std::string_view& line);
    std::size_t number() const { return number_; }
    std::string_view rest() const { return rest_; }
    /// Throws UnusableMesh with the number of the line.
    [[noreturn]] void fail(const std::string& what) const;
};

/// Takes it from `line`, with the blanks before it; empty at the end.
std::string_view nextWord(std::string_view& line);
/// The text without the blanks at both ends.
std::string_view trimmed(std::string_view);
/// Whether they are the same but for capitals; `lowerCase` has none.
bool isWord(std::string_view word, std::string_view lowerCase);
/// A piece of a file in quotes, for an error: at most forty characters, those that cannot be printed as ?.
std::string quoted(std::string_view);

/// The whole word as a number; none where it is none, or not finite.
std::optional<double> toFinite(std::string_view word);
/// The whole word as a number, nan where it says nan or inf.
std::optional<double> toFiniteOrNan(std::string_view word);
/// A whole number, before which a + may stand.
std::optional<std::int64_t> toWhole(std::string_view word);

/// Takes three finite numbers from `line`, which is the last one of `lines`; throws UnusableMesh.
Vector<3> takePoint(const TextLines& lines, std::string_view& line);
/// Throws UnusableMesh where more than numbers is left of `line`: colours and weights of points may be.
void expectNumbers(const TextLines& lines, std::string_view line);

}
