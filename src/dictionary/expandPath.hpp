/// Variables and names of folders in a path that a dictionary gives in quotes, by the rules of OpenFOAM 11 (stringOps::inplaceExpandEntry)
/// and of OpenFOAM 1912 for the names in angle brackets.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace sph
{

/// The path cannot be expanded, in words that follow its name: `names $MESHES, which is neither ...`.
class PathError : public std::runtime_error
{
public:
    using runtime_error::runtime_error;
};

/// FOAM_CASE and FOAM_CASENAME are this case's, whatever the shell says of another one.
std::optional<std::string> environmentVariable(const std::string& name, const std::filesystem::path& caseFolder);

/// The file of that name in an etc folder: that of the suite, $SPH_PROJECT_DIR/etc, then OpenFOAM's, $WM_PROJECT_DIR/etc. Throws PathError
/// where neither variable is set; a file that is in neither folder is named in the last one.
std::filesystem::path etcFile(const std::filesystem::path& name);

/// The text of an entry of the dictionary by its name as a macro has it; nothing where there is none.
using EntryText = std::function<std::optional<std::string>(const std::string& name)>;

/// Replaces $name and ${name} by an entry of the dictionary or else by the environment's, ${name:-text} and ${name:+text} as a shell does,
/// and at the beginning <case>, <constant>, <system>, <etc>, ~OpenFOAM, ~ and ./ (which is the case folder, where OpenFOAM's programs run).
/// A `\$` is left as it is. Throws PathError where a variable has no value: OpenFOAM puts nothing in its place.
std::string expandPath(const std::string& text, const std::filesystem::path& caseFolder, const EntryText& entry);

}
