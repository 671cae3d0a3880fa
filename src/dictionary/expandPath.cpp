#include "dictionary/expandPath.hpp"
#include <cctype>
#include <cstdlib>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace sph
{

namespace fs = std::filesystem;

namespace
{

bool isOfVariable(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
/// Entries of dictionaries are named with the characters of scopes as well: $base/nu, $..L
bool isOfName(char c) { return isOfVariable(c) || std::string_view("/!.:").find(c) != std::string_view::npos; }

class Expansion
{
    const std::string& text_;
    const fs::path& caseFolder_;
    const EntryText& entry_;
    std::size_t at_ = 0;

    bool sees(std::string_view s) const { return text_.compare(at_, s.size(), s) == 0; }

    std::string variable()
    {
        const auto begin = at_++;
        if (at_ < text_.size() && text_[at_] == '{') return braced(begin);
        while (at_ < text_.size() && isOfName(text_[at_])) ++at_;
        return valueOf(text_.substr(begin + 1, at_ - begin - 1));
    }

    /// ${name}, whose name may have variables in it
    std::string braced(std::size_t begin)
    {
        std::string name;
        for (++at_; at_ < text_.size() && text_[at_] != '}';)
            if (text_[at_] == '$') name += variable();
            else name += text_[at_++];
        if (at_ == text_.size()) throw PathError(fmt::format("has \"{}\", which is not closed by '}}'", text_.substr(begin)));
        ++at_;
        const auto colon = name.find(':');
        const char mark = colon != name.npos && colon + 1 < name.size() ? name[colon + 1] : '\0';
        if (colon == 0 || (mark != '-' && mark != '+')) return valueOf(name);
        const auto value = environmentVariable(name.substr(0, colon), caseFolder_);
        const auto alternative = name.substr(colon + 2);
        const bool isSet = value && !value->empty();
        if (mark == '-') return isSet ? *value : alternative;
        return isSet ? alternative : "";
    }

    /// The value of the longest beginning of a name that is one: the rest of `$FOAM_CASE/constant` belongs to the path.
    std::string valueOf(const std::string& name) const
    {
        if (const auto value = entry_(name)) return *value;
        std::size_t end = 0;
        while (end < name.size() && isOfVariable(name[end])) ++end;
        const auto variable = name.substr(0, end);
        if (const auto value = environmentVariable(variable, caseFolder_)) return *value + name.substr(end);
        if (const auto value = entry_(variable)) return *value + name.substr(end);
        throw PathError(fmt::format("names ${}, which is neither an entry that is defined above nor an environment variable",
                                    variable.empty() ? name : variable));
    }

public:
    Expansion(const std::string& text, const fs::path& caseFolder, const EntryText& entry)
        : text_(text), caseFolder_(caseFolder), entry_(entry)
    {}

    std::string run()
    {
        std::string result;
        while (at_ < text_.size())
            if (sees("\\$"))
            {
                result += "\\$";
                at_ += 2;
            }
            else if (text_[at_] == '$' && at_ + 1 < text_.size() && (text_[at_ + 1] == '{' || isOfName(text_[at_ + 1])))
                result += variable();
            else result += text_[at_++];
        return result;
    }
};

/// The path from the root, without "." and a '/' at its end.
fs::path wholePath(const fs::path& folder) { return (fs::absolute(folder).lexically_normal() / "").parent_path(); }

std::string inFolder(const std::string& path, const fs::path& caseFolder)
{
    const auto slash = std::min(path.find('/'), path.size());
    const auto head = path.substr(0, slash);
    const fs::path rest = slash < path.size() ? path.substr(slash + 1) : "";
    if (head == "<etc>" || head == "~OpenFOAM") return etcFile(rest).string();
    if (head == "~")
    {
        const char* home = std::getenv("HOME");
        if (!home) throw PathError("begins with ~, and the environment variable HOME is not set");
        return (home / rest).string();
    }
    if (path.starts_with("./")) return (wholePath(caseFolder) / rest).string();
    for (const auto& [tag, folder] : {std::pair{"<case>", ""}, {"<system>", "system"}, {"<constant>", "constant"}})
        if (head == tag) return (wholePath(caseFolder) / folder / rest).string();
    if (head.starts_with('<') && head.ends_with('>'))
        throw PathError(fmt::format("begins with {}; known are <case>, <constant>, <system> and <etc>", head));
    return path;
}

}

std::optional<std::string> environmentVariable(const std::string& name, const fs::path& caseFolder)
{
    const auto folder = wholePath(caseFolder);
    if (name == "FOAM_CASE") return folder.string();
    if (name == "FOAM_CASENAME") return folder.filename().string();
    const char* text = std::getenv(name.c_str());
    return text ? std::optional<std::string>(text) : std::nullopt;
}

fs::path etcFile(const fs::path& name)
{
    std::optional<fs::path> last;
    for (const char* variable : {"SPH_PROJECT_DIR", "WM_PROJECT_DIR"})
        if (const char* project = std::getenv(variable))
        {
            last = fs::path(project) / "etc" / name;
            std::error_code none;
            if (fs::exists(*last, none)) return *last;
        }
    if (last) return *last;
    throw PathError("is sought in etc folders, and neither of the environment variables SPH_PROJECT_DIR and WM_PROJECT_DIR, below which "
                    "they are, is set");
}

std::string expandPath(const std::string& text, const fs::path& caseFolder, const EntryText& entry)
{
    return inFolder(Expansion(text, caseFolder, entry).run(), caseFolder);
}

}
