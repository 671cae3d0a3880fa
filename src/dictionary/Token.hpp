/// The smallest pieces of a dictionary file.
#pragma once
#include "dictionary/Dictionary.hpp"
#include <cstddef>
#include <memory>
#include <string>

namespace sph
{

struct Token
{
    enum class Kind
    {
        word,
        number,
        string,
        verbatim,    ///< #{ text #}, and the text of #eval{ text }
        dimensions,  ///< [text]
        variable,    ///< $text or ${text}
        directive,   ///< #text
        punctuation, ///< one of ; { } ( ) , / =
        dictionary   ///< { .. } inside a list, parsed; the text is its name as it was written
    };

    Kind kind = Kind::word;
    /// Text without the marks that delimit it.
    std::string text;
    int line = 0, lastLine = 0;
    /// Column from 1; it tells a continued value from the next entry where a ';' is missing.
    int column = 0;
    bool firstOnLine = false;
    /// Place of the token in the text of the file, for editing.
    std::size_t begin = 0, end = 0;
    std::shared_ptr<Dictionary::Node> dictionary = nullptr;

    bool is(char c) const { return kind == Kind::punctuation && text[0] == c; }
    bool isText() const { return kind == Kind::word || kind == Kind::string; }
};

/// Text of a token as it is written in a file.
std::string toString(const Token&);

}
