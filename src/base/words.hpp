/// Help with misspelt words.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace sph
{

/// Letters to change, insert, drop or swap with their neighbour to get from a to b (Damerau's distance, each letter edited once).
int distance(const std::string& a, const std::string& b);

/// The word of `known` that was probably meant by `word`, capitals apart, or an empty string where none is near.
std::string nearest(const std::string& word, std::span<const std::string> known);

/// `Did you mean "x"? Known <things>: a, b, c.` with the question only where a word is near.
std::string suggestion(const std::string& word, const std::string& things, std::span<const std::string> known);

/// "a, b, c"
std::string list(std::span<const std::string> words);

/// First characters of a text, and "..." where it is long, for messages that quote a file.
std::string beginning(const std::string& text);

}
