/// A cloud of particles on disk, `<time>/lagrangian/<cloud>/`, as OpenFOAM and ParaView read it: `positions` and one file per field.
#pragma once
#include "base/CaseError.hpp"
#include "base/values.hpp"
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sph
{

/// A field in memory, one array per component; read-only view. A null component is written as zeros (z of a 2-D scene).
struct FieldView
{
    std::string name;
    FieldClass type = FieldClass::scalar;
    std::vector<const double*> component;
};

/// The view of a field whose values are of this type: each component at its place on disk.
FieldView fieldView(const std::string& name, const ValueType&, const std::vector<const double*>& component);

struct CloudField
{
    FieldClass type = FieldClass::scalar;
    std::vector<std::vector<double>> component;
};

/// The k-th of so many even parts of a list: of a cloud that ranks share, each reads its own.
struct Slice
{
    std::size_t part = 0, parts = 1;
    std::size_t begin(std::size_t n) const { return part * n / parts; }
    std::size_t end(std::size_t n) const { return (part + 1) * n / parts; }
};

/// A cloud in memory: one array per component of the positions, and the fields by name.
struct Cloud
{
    std::string folder; ///< that it was read from, "0.1/lagrangian/sph"
    std::vector<double> x, y, z;
    std::map<std::string, CloudField> fields;
    std::size_t before = 0; ///< particles of the file that were not read: a slice has those behind them
    std::size_t size() const { return x.size(); }
    /// "particle 3 at (0 0 0)", by its place in the file, for messages.
    std::string particle(std::size_t i) const;
};

enum class WriteFormat
{
    ascii,
    binary
};

struct WriteOptions
{
    WriteFormat format = WriteFormat::binary;
    /// Digits in ascii; 0: the shortest text that reads back to the same number, so that a restart loses nothing.
    int precision = 0;
};

/// Writes one cloud, with `<time>/uniform/lagrangian/<cloud>/cloudProperties`, into a time folder that need not exist yet.
/// A field whose values are all equal is written in compact form, `N{value}`, in ascii. Ranks write one cloud together, each its n particles behind
/// those of the ranks before it; the folder has none yet then.
void writeCloud(const std::filesystem::path& timeFolder, const std::string& cloud, std::size_t n, const FieldView& positions,
                const std::vector<FieldView>& fields, const WriteOptions&);

/// Classes of fields by name.
using FieldClasses = std::map<std::string, FieldClass>;

/// Reads `positions` and every field file that is there. Everything that is wrong (unreadable, truncated, unequal lengths, NaN or infinite, a
/// class that is none or, of a field that `wanted` names, not that one) is recorded with file, line (ascii) and particle. `caseFolder` makes the
/// paths in messages short. Of a slice, memory is taken for its particles alone: binary files are not even looked at beyond it, but for their length; of
/// ascii files all is checked.
Cloud readCloud(const std::filesystem::path& caseFolder, const std::string& time, const std::string& cloud, Diagnostics&,
                const FieldClasses& wanted = {}, const Slice& = {});

/// The phase of each particle, 0 where the cloud has no field `phase`. Throws CaseError, with file and particle, where there is no such phase.
std::vector<int> phasesOf(const Cloud&, std::size_t phases);

/// The field V, or m/rho where there is none [m^3]. Throws CaseError, with file and particle, where a field is missing or a value is not positive.
std::vector<double> volumesOf(const Cloud&);

bool hasCloud(const std::filesystem::path& caseFolder, const std::string& time, const std::string& cloud);

/// The one-cell polyMesh around [low, high] that ParaView and OpenFOAM want to see (5 files in constant/polyMesh).
void writePolyMesh(const std::filesystem::path& folder, const double (&low)[3], const double (&high)[3]);
/// Writes the mesh of the box between these corners, and an empty `<case>.foam` to open.
void writeBoundingMesh(const std::filesystem::path& caseFolder, const double (&low)[3], const double (&high)[3]);

}
