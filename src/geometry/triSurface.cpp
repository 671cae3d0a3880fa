#include "geometry/triSurface.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const FileName surfaceFile{
    "file", "constant/triSurface", required,
    "in constant/triSurface: .stl, .stlb, .obj, .ply, .off, .gltf or .glb; with `volume` voxels: .mhd, .mha, or raw"};
const Choice surfaceFluid{"fluid",
                          {"inside", "outside"},
                          required,
                          "side of the outermost surfaces on which the fluid is; nested ones alternate"};
const Scalar surfaceScale{"scale", units::none, 1.0, positive, "of the file's lengths to m: 1e-3 for mm"};
const SubDictionary rotation{"rotation", notGiven, "about the origin of the file's coordinates, after scaling"};
const Direction surfaceAxis{"axis", required, "of the rotation"};
const Scalar angle{"angle", degrees, required, "counter-clockwise as seen against the axis"};
const VectorParameter surfaceTranslation{"translation", units::m, Vector<3>{}, "after the rotation"};
const Scalar weld{"weld", units::m, byScene("1e-6 of the diagonal of the mesh"), nonNegative, "points nearer to each other become one"},
    closeHoles{"closeHoles", units::m, notGiven, positive, "holes no wider than this are closed; an open mesh is an error otherwise"},
    tolerance{"tolerance", units::m, required, positive, "of the wrap: it lies outside the mesh by half of this"},
    alpha{"alpha", units::m, byScene("5 tolerance"), positive,
          "radius of a ball that the wrap does not let through: narrower holes and crevices are bridged"},
    edgeLength{"edgeLength", units::m, notGiven, positive, "of the facets that replace the file's: remeshing; without it none"},
    featureAngle{"featureAngle", degrees, 30.0, positiveUpTo(180),
                 "between the normals of two facets: edges that turn more are sharp, and kept by remeshing"};
const Switch removeSelfIntersections{"removeSelfIntersections", false,
                                     "bodies that overlap or touch become one, and what crosses itself the outside of all that it winds "
                                     "around: box and volume stay, or it is refused; an error otherwise"};
const SubDictionary wrap{"wrap", notGiven, "a closed surface around a mesh that has holes or crosses itself, as scans have"};
const SubDictionary volume{"volume", notGiven,
                           "the file is a volume of voxels, as micro-CT gives it, and the wall the surface of the solid in it"};
const Scalar threshold{"threshold", units::none, notGiven, anyNumber, "grey value from which on a voxel is solid; this or label"},
    label{"label", units::none, notGiven, anyNumber, "value of the voxels that are solid, in a segmented volume"},
    voxelSize{"voxelSize", units::none, byScene("ElementSpacing of .mhd and .mha"), positive,
              "edge of a voxel, in the lengths that scale turns to m"},
    smoothing{"smoothing", Unit{units::none, "voxels"}, byScene("2 with label, 0 with threshold"), between(0, 10),
              "standard deviation of the kernel that takes away the steps of segmented voxels; the porosity stays"};
const Choice solidSide{"solid", {"above", "below"}, "above", "side of the threshold on which the solid is"},
    dataType{"dataType",
             {"uint8", "int8", "uint16", "int16", "uint32", "int32", "float32", "float64"},
             byScene("needed of a raw file"),
             "of a voxel in a raw file"},
    byteOrder{"byteOrder", {"little", "big"}, "little", "of the numbers of a raw file: the end that comes first"};
const ListOf<int> cells{"cells", byScene("needed of a raw file"), "number of voxels along x, which goes fastest, y and z"};
const Count headerBytes{"headerBytes", 0, nonNegative, "of a raw file that stand before its voxels"};
const SubDictionary regions{"regions", notGiven, "regions of the file with properties other than the wall's"};
const FreeName region{"<region>", "dictionary",
                      "a region by its name in the file: solid of an ascii STL, group or object of an OBJ, material of a glTF"};
}

EntryList triSurfaceEntries(const EntryList& ofRegion)
{
    using namespace entry;
    return {surfaceFile,
            surfaceFluid,
            surfaceScale,
            {rotation, {surfaceAxis, angle}},
            surfaceTranslation,
            weld,
            closeHoles,
            removeSelfIntersections,
            {wrap, {tolerance, alpha}},
            edgeLength,
            featureAngle,
            {volume, {threshold, label, solidSide, voxelSize, smoothing, cells, dataType, byteOrder, headerBytes}},
            {regions, {{region, ofRegion}}}};
}

namespace
{

bool isMetaImage(const std::string& file) { return file.ends_with(".mhd") || file.ends_with(".mha"); }

TriSurface::Volume readVolume(const Dictionary& dict, const std::string& file)
{
    TriSurface::Volume v;
    v.threshold = entry::threshold.ifGiven(dict);
    v.label = entry::label.ifGiven(dict);
    if (v.threshold.has_value() == v.label.has_value())
        dict.diagnostics().error(
            dict.location(),
            "a volume needs either `threshold`, the grey value from which on it is solid, or `label`, the value of its solid voxels");
    if (v.threshold) v.solidBelow = entry::solidSide(dict) == "below";
    v.smoothing = entry::smoothing(dict, v.label ? 2 : 0);
    v.voxelSize = entry::voxelSize.ifGiven(dict);
    if (isMetaImage(file)) return v; // whose header says the rest
    if (!v.voxelSize)
        dict.diagnostics().error(
            dict.location(),
            fmt::format("nobody knows how large a voxel of {} is: add `voxelSize`, in the lengths that scale turns to m", file));
    const auto cells = entry::cells.needed(dict);
    if (cells.size() == 3) std::ranges::copy(cells, v.cells.begin());
    else if (entry::cells.given(dict))
        entry::cells.error(dict, fmt::format("three numbers of voxels are needed, and there are {}", cells.size()));
    v.dataType = entry::dataType.needed(dict);
    v.bigEndian = entry::byteOrder(dict) == "big";
    v.headerBytes = entry::headerBytes(dict);
    return v;
}

}

std::vector<Dictionary> regionsOf(const Dictionary& wall)
{
    const auto regions = entry::regions(wall);
    std::vector<Dictionary> all;
    for (const auto& name : regions.keys())
        if (regions.isDictionary(name)) all.push_back(regions.subDict(name));
        else regions.error(name, fmt::format("region \"{0}\" must be a dictionary: {0} {{ contactAngle 30; }}", name));
    return all;
}

TriSurface readTriSurface(const Dictionary& wall)
{
    TriSurface t;
    t.wall = wall.keyword();
    t.file = entry::surfaceFile(wall);
    t.at = entry::surfaceFile.where(wall);
    t.scaleAt = entry::surfaceScale.where(wall);
    t.fluid = entry::surfaceFluid(wall) == "inside" ? FluidSide::inside : FluidSide::outside;
    t.scale = entry::surfaceScale(wall);
    if (entry::rotation.given(wall))
    {
        const auto rotation = entry::rotation(wall);
        t.axis = entry::surfaceAxis(rotation);
        t.angle = entry::angle(rotation);
    }
    t.translation = entry::surfaceTranslation(wall);
    t.weld = entry::weld.ifGiven(wall);
    t.closeHoles = entry::closeHoles.ifGiven(wall);
    t.removeSelfIntersections = entry::removeSelfIntersections(wall);
    if (entry::wrap.given(wall))
    {
        const auto wrap = entry::wrap(wall);
        const double tolerance = entry::tolerance(wrap);
        t.wrap = {tolerance, entry::alpha(wrap, 5 * tolerance)};
        // A wrap is closed and crosses nothing: what these would repair is gone.
        for (const Parameter* idle :
             {static_cast<const Parameter*>(&entry::closeHoles), static_cast<const Parameter*>(&entry::removeSelfIntersections)})
            if (idle->given(wall)) idle->error(wall, "a wrap leaves no holes and no intersections: leave out the one or the other");
    }
    if (entry::volume.given(wall)) t.volume = readVolume(entry::volume(wall), t.file);
    else if (isMetaImage(t.file) || t.file.ends_with(".raw"))
        entry::surfaceFile.error(
            wall, fmt::format("{} is a volume of voxels: add what of it is solid, `volume {{ label 1; }}` or `volume {{ threshold 100; }}`",
                              t.file));
    t.edgeLength = entry::edgeLength.ifGiven(wall);
    t.featureAngle = entry::featureAngle(wall);
    for (const auto& region : regionsOf(wall)) t.regions.push_back(region.keyword());
    return t;
}

}
