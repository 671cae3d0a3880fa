/// Parser that turns the tokens of a file into the entries of a dictionary, carrying out directives and macros on the way.
///
/// Nothing throws: a mistake is recorded where it was made, and parsing goes on at the next place that looks like the beginning
/// of an entry, so that the mistakes of a file are reported together.
#pragma once
#include "dictionary/DictionaryNode.hpp"
#include "dictionary/Expression.hpp"
#include <filesystem>

namespace sph
{

class DictionaryParser
{
public:
    /// State that a file shares with the files that it includes.
    struct Context
    {
        std::filesystem::path caseFolder;
        std::shared_ptr<Diagnostics> diagnostics;
        InputMode mode = InputMode::merge;
        /// Files being read, the including ones first.
        std::vector<std::filesystem::path> open = {};
        /// Dictionaries and files that are open, and all words until now, those of macros included: see limits.hpp.
        int nesting = 0, included = 0;
        std::size_t words = 0;
        /// A limit is passed: nothing more is read.
        bool stopped = false;
    };

    /// `file` as messages name it; includes are sought relative to `folder`.
    DictionaryParser(Context&, const std::string& text, std::string file, std::filesystem::path folder);

    void parse(Dictionary::Node& into);

private:
    /// An #if that is not ended yet.
    struct Branch
    {
        std::string directive;
        int line;
        bool elseSeen = false;
    };

    Context& context_;
    std::string file_;
    std::filesystem::path folder_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0, textSize_, mostErrors_;
    std::vector<Branch> branches_;
    /// The dictionary that the file's own entries go into.
    const Dictionary::Node* top_ = nullptr;
    /// The first block whose closing brace stands elsewhere than its opening one: where a brace is missing, it is here.
    std::optional<std::string> suspect_;
    int suspectLine_ = 0;

    bool atEnd() const { return at_ >= tokens_.size(); }
    const Token& peek() const { return tokens_[at_]; }
    bool sameLine(int line) const { return !atEnd() && peek().line == line && !peek().firstOnLine; }
    void error(int line, std::string what);
    /// Records the error that a limit is passed, the last one.
    void stop(int line, const std::string& why);
    /// Whether so much more may come to be here.
    bool fits(int line, const Dictionary::Node::Extent&);

    void entries(Dictionary::Node& scope, const Token* opening);
    void entry(Dictionary::Node& scope, const Token& keyword, InputMode);
    void subDictionary(Dictionary::Node& scope, DictionaryEntry, InputMode);
    /// The header of an included file is none of the dictionary's that includes it.
    bool isOthersHeader(const Dictionary::Node& scope, const Token& keyword) const;
    void value(Dictionary::Node& scope, DictionaryEntry&, const Token& keyword);
    bool semicolonMissing(const Token& keyword, bool hasValue) const;
    void listedDictionary(Dictionary::Node& scope, DictionaryEntry&, std::size_t& unnamed);
    bool blockClosesValue() const;
    void listNotClosed(const Token& keyword, const Token& opening);
    void checkBraces(const Dictionary::Node& scope, const Token& opening, const Token& closing);
    void skipBlock();
    void skipToNextEntry();

    void mergeMacro(Dictionary::Node& scope, const Token& variable);
    std::vector<Token> expand(Dictionary::Node& scope, const Token& variable);
    std::vector<Token> eval(Dictionary::Node& scope, const Token& directive);
    void take(DictionaryEntry&, int line) const;
    ExpressionValue macroValue(Dictionary::Node& scope, const std::string& name, int line) const;
    void undefinedMacro(Dictionary::Node& scope, const Token& variable);
    /// Text of an entry as a path may name it; nothing where there is no such entry. Throws PathError where it is more than one word.
    std::optional<std::string> textOf(Dictionary::Node& scope, const std::string& name, int line) const;

    void directive(Dictionary::Node& scope, const Token& directive);
    void unsupported(const Token& directive);
    void include(Dictionary::Node& scope, const Token& directive);
    void inputMode(const Token& directive);
    void modifiedEntry(Dictionary::Node& scope, const Token& directive);
    void remove(Dictionary::Node& scope, const Token& directive);
    void openBranch(Dictionary::Node& scope, const Token& directive);
    void endOrElse(Dictionary::Node& scope, const Token& directive);
    bool condition(Dictionary::Node& scope, const Token& directive);
    /// Goes to the branch to be read: behind the #else, the first #elif that holds, or the #endif.
    void skipBranch(Dictionary::Node& scope, bool seekElse);
    void markMentioned(Dictionary::Node& scope, const Token&) const;
    std::vector<Token> restOfLine(Dictionary::Node& scope, int line);
};

/// The words that OpenFOAM takes for true and false.
std::optional<bool> toSwitch(const std::string& word);

}
