/// Names of regions in a file, and as words of a dictionary. For the sources of this module alone.
#pragma once
#include "meshes/readers/NumberedMesh.hpp"
#include <map>
#include <string_view>

namespace sph
{

class RegionNames
{
    std::map<std::string, int, std::less<>> known_;
    std::vector<std::string> words_;
    std::vector<std::string>& notes_;

public:
    explicit RegionNames(std::vector<std::string>& notes) : notes_(notes) {}
    /// The number of the region, new or known: empty becomes `patch<number>`, a name that is no word one, with a note.
    int index(std::string_view nameInFile);
    const std::vector<std::string>& words() const { return words_; }
};

}
