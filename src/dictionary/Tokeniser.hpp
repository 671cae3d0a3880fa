/// Tokeniser that cuts the text of a dictionary file into tokens, by the rules of OpenFOAM's ISstream.
#pragma once
#include "dictionary/Token.hpp"
#include <vector>

namespace sph
{

/// Records what cannot be a token, or is never closed, where it begins, and goes on behind it.
std::vector<Token> tokenise(const std::string& text, const std::string& file, Diagnostics&);

/// The number that all of the text is, if it is one. Infinity where it is too large for a double.
std::optional<double> toNumber(std::string_view text);

}
