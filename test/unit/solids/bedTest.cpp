/// Beds are at rest, within their container, free of overlaps, as porous as beds are, and the same for the same seed.
#include "Largest.hpp"
#include "TestCase.hpp"
#include "solids/BedReport.hpp"
#include "solids/CollisionShape.hpp"
#include "solids/meshDistance.hpp"
#include "solids/rocks/closedSurface.hpp"
#include "solids/rocks/makeRock.hpp"
#include <gtest/gtest.h>

namespace sph::test
{

namespace
{

const std::string gravity = "value (0 0 -9.81);\n";

Files withRocks(const std::string& solids)
{
    Files files{{"system/packParticlesDict", "solids\n{\n" + solids + "}\n"}, {"constant/g", gravity}};
    for (const auto& kind : rockKinds())
        files["constant/triSurface/" + kind.name + ".obj"] = objText({{kind.name, makeRock(kind, 80, 1, 1)}});
    return files;
}

struct Packed
{
    SolidsPlan plan;
    Bed bed;
    BedMeasures measures;
};

Packed pack(const Files& files)
{
    const TestCase folder(files);
    const Case c(folder.folder());
    Packed p{readSolidsPlan(c), {}, {}};
    p.bed = packSolids(c, p.plan, [](const std::string&) {});
    p.measures = measure(p.plan, p.bed);
    return p;
}

/// The whole message, of reading or of packing.
std::string errorOf(const std::string& solids, const Files& more = {})
{
    auto files = withRocks(solids);
    for (const auto& [name, text] : more) files[name] = text;
    try
    {
        pack(files);
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

const std::string cylinder =
    "count 150;\nfriction 0.1;\ncontainer { type cylinder; base (0 0 0); radius 0.03; height 0.2; }\nsize { value 0.01; }\n";
const std::string rocks = "count 20;\nseed 3;\ncontainer { type box; min (0 0 0); max (0.05 0.05 0.2); }\n"
                          "shapes ( { file \"angular.obj\"; } { file \"rounded.obj\"; } { file \"concave.obj\"; } );\n"
                          "size { distribution uniform; min 0.012; max 0.018; }\n";

}

// Spheres of a sixth of the cylinder's diameter. Loose random packings of spheres have porosities of 0.40 to 0.44 far from walls (Onoda &
// Liniger 1990, Dullien 1992), and 0.44 to 0.48 over a cylinder as narrow as this, since the porosity is 1 at its wall and 0.25 half a diameter
// from it (Benenati & Brosilow 1962).
TEST(Bed, SpheresInACylinder)
{
    const auto [plan, bed, m] = pack(withRocks(cylinder));
    EXPECT_EQ(bed.bodies.size(), 150u);
    EXPECT_LT(bed.kineticEnergy, 1e-6);
    EXPECT_LT(bed.overlap, 1e-3);
    EXPECT_GT(m.porosity, 0.42);
    EXPECT_LT(m.porosity, 0.48);
    ASSERT_TRUE(m.corePorosity);
    EXPECT_GT(*m.corePorosity, 0.38);
    EXPECT_LT(*m.corePorosity, 0.45);
    // A sphere that stands on three others has six contacts with the three that stand on it, fewer where walls carry it.
    EXPECT_GT(m.coordination, 4);
    EXPECT_LT(m.coordination, 6);
    for (const auto& b : bed.bodies)
    {
        EXPECT_LT(std::hypot(b.centre.x, b.centre.y) + 0.5 * b.size, 0.03 + 1e-5);
        EXPECT_GT(b.centre.z - 0.5 * b.size, -1e-5);
    }
}

// The bed rests as it stands: the weight of each sphere's neighbours leaves no sphere hanging. Each touches three others or walls at least, below
// and around it.
TEST(Bed, NothingHangs)
{
    const auto [plan, bed, m] = pack(withRocks(cylinder));
    std::vector<int> support(bed.bodies.size());
    for (const auto& [i, j, gap] : bed.contacts)
    {
        const auto lower = bed.bodies[std::size_t(i)].centre.z < bed.bodies[std::size_t(j)].centre.z ? j : i;
        ++support[std::size_t(lower)];
    }
    for (std::size_t i = 0; i < bed.bodies.size(); ++i)
    {
        const auto& b = bed.bodies[i];
        if (b.centre.z - 0.5 * b.size < 1e-4) ++support[i];
        EXPECT_GE(support[i], 1) << i;
    }
}

// Without walls at its sides a bed has the porosity of loose packings all over, and contacts cross the sides. Its profile, exact, has the mean of
// the spheres' volume.
TEST(Bed, PeriodicSides)
{
    const auto [plan, bed, m] =
        pack(withRocks("count 120;\nfriction 0.1;\nsize { distribution normal; mean 0.01; standardDeviation 0.001; min 0.008; "
                       "max 0.012; }\ncontainer { type box; min (0.1 0 0); max (0.15 0.05 0.1); periodic (x y); }\n"));
    EXPECT_LT(bed.kineticEnergy, 1e-6);
    EXPECT_LT(bed.overlap, 1e-3);
    EXPECT_GT(m.porosity, 0.36);
    EXPECT_LT(m.porosity, 0.44);
    std::size_t across = 0;
    for (const auto& [i, j, gap] : bed.contacts)
        across += mag(bed.bodies[std::size_t(i)].centre - bed.bodies[std::size_t(j)].centre) > 0.02;
    EXPECT_GT(across, 20u);
    double profile = 0, middle = 0;
    for (const double p : m.layerPorosity) profile += p / double(m.layerPorosity.size());
    double solid = 0;
    for (const auto& b : bed.bodies)
    {
        // Share of the sphere below the bed's height
        const double depth = std::clamp((m.height - b.centre.z) / b.size + 0.5, 0.0, 1.0);
        solid += std::numbers::pi / 3 * std::pow(b.size, 3) * depth * depth * (1.5 - depth);
        middle += b.size / double(bed.bodies.size());
    }
    EXPECT_NEAR(profile, 1 - solid / (plan.container.area() * m.height), 1e-9);
    EXPECT_NEAR(middle, 0.01, 1e-5);
}

// Rocks, one kind of them concave, come to rest; none is outside, and in the end none overlaps another: by facets, not by what Bullet says.
TEST(Bed, Rocks)
{
    const auto [plan, bed, m] = pack(withRocks(rocks));
    EXPECT_EQ(bed.bodies.size(), 20u);
    EXPECT_LT(bed.kineticEnergy, 1e-6);
    EXPECT_LT(bed.overlap, 0.01);
    for (const auto& b : bed.bodies) EXPECT_LT(b.shrunk, 0.011);
    EXPECT_LT(m.shrunk, 0.6 * bed.overlap); // the deepest overlap is that of two solids
    EXPECT_EQ(largestOverlap(plan.container, bed), 0);
    EXPECT_GT(bed.contacts.size(), 15u);
    EXPECT_NE(bed.notes[2].find("convex parts"), std::string::npos) << bed.notes[2];
    for (const auto& b : bed.bodies)
        for (const auto& x : placed(plan.container, bed.shapeOf(b), b).points)
        {
            EXPECT_TRUE(x.x >= 0 && x.x <= 0.05 && x.y >= 0 && x.y <= 0.05 && x.z >= 0 && x.z <= 0.2);
        }
}

// Rocks between periodic sides: at rest, apart also across the sides, and touching there as often as their share of the bed says. A body that the sides
// cut lies whole on one of them. Where a shape has several parts the points of each are found.
TEST(Bed, RocksAcrossPeriodicSides)
{
    const auto [plan, bed, m] =
        pack(withRocks("count 40;\nfriction 0.3;\ncontainer { type box; min (0 0 0); max (0.06 0.06 0.2); periodic (x y); }\n"
                       "shapes ( { file \"angular.obj\"; } { file \"concave.obj\"; } { share 0.5; } );\n"
                       "size { distribution uniform; min 0.012; max 0.016; }\n"));
    EXPECT_EQ(bed.bodies.size(), 40u);
    EXPECT_LT(bed.kineticEnergy, 1e-6);
    EXPECT_LT(bed.overlap, 0.01);
    EXPECT_EQ(largestOverlap(plan.container, bed), 0);
    std::size_t across = 0, meshesAcross = 0;
    for (const auto& [i, j, gap] : bed.contacts)
    {
        const auto &a = bed.bodies[std::size_t(i)], &b = bed.bodies[std::size_t(j)];
        if (mag(a.centre - b.centre) < 0.03) continue;
        ++across;
        meshesAcross += !bed.shapeOf(a).isSphere() && !bed.shapeOf(b).isSphere();
    }
    EXPECT_GT(meshesAcross, 5u);
    EXPECT_GT(across, bed.contacts.size() / 5);
    EXPECT_LT(across, bed.contacts.size() / 2);
    // Nothing says where the sides are: the bed is as dense beside them as in the middle.
    ASSERT_TRUE(m.corePorosity.has_value());
    EXPECT_NEAR(*m.corePorosity, m.porosity, 4 * m.coreError);
    // Each copy against each, by no rule for periods at all.
    Bed all;
    all.shapes = bed.shapes;
    auto wide = plan.container;
    wide.periodic = {};
    wide.base = {-1, -1, 0};
    wide.length = wide.width = 3;
    for (const double x : {0.0, 0.06})
        for (const double y : {0.0, 0.06})
            for (auto b : bed.bodies)
            {
                b.centre = b.centre + Vector<3>{x + 1, y + 1, 0};
                all.bodies.push_back(b);
            }
    EXPECT_EQ(largestOverlap(wide, all), 0);
}

// A slender plate bent to a right angle, far from convex: what it collides as covers it, without closing the angle as its hull does.
TEST(Bed, PartsCoverAnAngle)
{
    const auto shapeOf = [](const std::string& collision)
    {
        TriangleSurface angle; // an L of 3 x 3 and thickness 1, extruded by 1
        const std::vector<std::array<double, 2>> outline{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
        for (const double z : {0.0, 1.0})
            for (const auto& [x, y] : outline) angle.points.push_back({x, y, z});
        for (int k = 0; k < 6; ++k)
        {
            const int l = (k + 1) % 6;
            angle.triangles.push_back({k, l, l + 6});
            angle.triangles.push_back({k, l + 6, k + 6});
        }
        for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}})
        {
            angle.triangles.push_back({a, c, b});
            angle.triangles.push_back({a + 6, b + 6, c + 6});
        }
        const TestCase folder(
            Files{{"constant/triSurface/angle.obj", objText({{"angle", angle}})},
                  {"system/packParticlesDict", "solids { count 1; size { value 1; } container { type box; min (0 0 0); max (9 9 9); } "
                                               "shapes ( { file \"angle.obj\"; collision " +
                                                   collision + "; } ); }\n"}});
        const Case c(folder.folder());
        return makeCollisionShape(readSolidShape(c, readSolidsPlan(c).shapes[0])).description;
    };
    EXPECT_NE(shapeOf("automatic").find("convex parts, volumes together 1 of"), std::string::npos) << shapeOf("automatic");
    EXPECT_NE(shapeOf("hull").find("convex hull, 40 % more volume"), std::string::npos) << shapeOf("hull");
}

// An agglomerate is the union of its grain and fines: closed, in one piece, of the volume of a sphere of diameter 1, and a point lies in it where it lies in one of them. Its convex
// parts are these.
TEST(Bed, Agglomerates)
{
    const TestCase folder(withRocks(
        "count 1;\nsize { value 1; }\ncontainer { type box; min (0 0 0); max (9 9 9); }\nshapes ( { file \"angular.obj\"; fines { "
        "massShare 0.2; min 0.15; max 0.3; variants 2; } } { fines { massShare 0.1; min 0.2; file \"flat.obj\"; bond 0.1; } } "
        "{ file \"angular.obj\"; fines { massShare 0.05; min 0.3; } } );\n"));
    const Case c(folder.folder());
    const auto plan = readSolidsPlan(c);
    ASSERT_EQ(plan.shapes.size(), 4u);
    EXPECT_EQ(plan.shapes[0].share, 0.5);
    EXPECT_EQ(readSolidShape(c, plan.shapes[1]).file, "constant/triSurface/angularFines2.obj");
    EXPECT_EQ(readSolidShape(c, plan.shapes[2]).file, "constant/triSurface/sphereFines1.obj");
    EXPECT_EQ(readSolidShape(c, plan.shapes[3]).file, "constant/triSurface/angularFines3.obj");
    for (const auto& [k, fines] : {std::pair{0, 20}, {1, 20}, {2, 14}})
    {
        const auto& asked = plan.shapes[std::size_t(k)];
        const auto shape = readSolidShape(c, asked);
        ASSERT_EQ(shape.pieces.size(), std::size_t(fines) + 1) << k;
        EXPECT_EQ(looseEdges(shape.mesh), 0u) << k;
        const auto moments = volumeMoments(shape.mesh);
        EXPECT_NEAR(moments.volume, std::numbers::pi / 6, 1e-9) << k;
        EXPECT_LT(mag(moments.centroid), 1e-9) << k;
        double mass = 0;
        for (const auto& piece : shape.pieces) mass += volumeMoments(piece).volume;
        EXPECT_NEAR(1 - volumeMoments(shape.pieces[0]).volume / mass, asked.fines->massShare, 0.01) << k;
        Noise noise(1);
        int inside = 0;
        for (int n = 0; n < 1500; ++n)
        {
            const Vector<3> x{noise.between(-1, 1), noise.between(-1, 1), noise.between(-1, 1)};
            const bool isInPiece = std::ranges::any_of(shape.pieces, [&](const auto& piece) { return isInside(piece, x); });
            EXPECT_EQ(isInside(shape.mesh, x), isInPiece) << k << " " << x.x << " " << x.y << " " << x.z;
            inside += isInPiece;
        }
        EXPECT_NEAR(inside / 1500.0 * 8, std::numbers::pi / 6, 0.2) << k;
        const auto form = makeCollisionShape(shape).description;
        EXPECT_NE(form.find(std::to_string(fines + 1) + " convex parts"), std::string::npos) << form;
    }
    EXPECT_NE(readSolidShape(c, plan.shapes[0]).mesh.points, readSolidShape(c, plan.shapes[1]).mesh.points);
}

// A bed of agglomerates comes to rest without overlaps, and its files are those of any bed: meshToGhost takes the merged surface.
TEST(Bed, OfAgglomerates)
{
    const TestCase folder(
        withRocks("count 4;\nfriction 0.3;\nsize { value 0.014; }\ncontainer { type box; min (0 0 0); max (0.045 0.045 0.1); }\n"
                  "shapes ( { file \"angular.obj\"; fines { massShare 0.1; min 0.3; } } );\n"));
    folder.write("constant/geometry",
                 "dimension 3;\ndomain { min (0 0 0); max (0.045 0.045 0.1); }\nwalls { bed { type triSurface; file \"solids.obj\"; fluid "
                 "outside; } }\n");
    folder.write("constant/phaseProperties", "phases (water);\nwater { rho 1000; mu 1e-3; soundSpeed 1; }\n");
    folder.write("system/sphSchemes", "resolution { spacing 5e-4; support 2.6; kernel wendlandC2; }\n");
    const auto out = folder.runWell("packParticles", "-solids", 1, 120);
    EXPECT_NE(out.find("angularFines1.obj: 4 fines, 0.0975 of the mass"), std::string::npos) << out;
    EXPECT_NE(out.find("5 convex parts"), std::string::npos) << out;
    const Case c(folder.folder());
    const auto dict = c.dictionary("constant/solids");
    const auto file = dict.dictionaries("shapes")[0].get<std::string>("file");
    EXPECT_EQ(file, "constant/triSurface/angularFines1.obj");
    double volume = 0;
    for (const auto& body : dict.dictionaries("bodies"))
        volume += volumeMoments(readSurface(folder.folder(), file)).volume * std::pow(body.get<double>("scale"), 3);
    const auto merged = readSurface(folder.folder(), "constant/triSurface/solids.obj");
    EXPECT_EQ(looseEdges(merged), 0u);
    EXPECT_NEAR(volumeMoments(merged).volume / volume, 1, 1e-9);
    folder.runWell("meshToGhost", "", 1, 120);
}

// The files say the same: the dictionary's formula gives the merged surface, whose groups are the shapes and whose volume is that of the rocks.
TEST(Bed, FilesOfRocks)
{
    const TestCase folder(withRocks(rocks + "shrink 0.02;\n"));
    folder.write("constant/g", "value (0 -9.81 0);\n");
    folder.replace("system/packParticlesDict", "max (0.05 0.05 0.2)", "max (0.05 0.2 0.05)");
    const auto out = folder.runWell("packParticles", "-solids", 1, 120);
    EXPECT_NE(out.find("all solids then made 2 % smaller"), std::string::npos) << out;
    const Case c(folder.folder());
    const auto dict = c.dictionary("constant/solids");
    const auto shapes = dict.dictionaries("shapes"), bodies = dict.dictionaries("bodies");
    ASSERT_EQ(bodies.size(), 20u);
    const auto merged = readSurface(folder.folder(), "constant/triSurface/solids.obj");
    EXPECT_EQ(looseEdges(merged), 0u);
    double volume = 0;
    for (const auto& body : bodies)
    {
        const auto& shape = shapes[std::size_t(body.get<int>("shape"))];
        const auto original = readSurface(folder.folder(), shape.get<std::string>("file"));
        const auto q = body.get<std::vector<double>>("rotation");
        const Rotation R{q[0], {q[1], q[2], q[3]}};
        const double scale = body.get<double>("scale");
        volume += scale * scale * scale * volumeMoments(original).volume;
        const auto first = body.get<Vector<3>>("centre") + scale * R(original.points.front() - shape.get<Vector<3>>("centroid"));
        double nearest = 1;
        for (const auto& p : merged.points) nearest = std::min(nearest, mag(p - first));
        EXPECT_LT(nearest, 1e-12);
    }
    EXPECT_NEAR(volumeMoments(merged).volume / volume, 1, 1e-9);
    double highest = 0;
    for (const auto& p : merged.points) highest = std::max(highest, p.y);
    EXPECT_LT(highest, 0.12); // up is y
    for (const auto* name : {"g angular\n", "g rounded\n", "g concave\n"})
        EXPECT_NE(folder.read("constant/triSurface/solids.obj").find(name), std::string::npos);
    for (const auto* file : {"porosity", "contacts", "bed"}) EXPECT_TRUE(folder.has("postProcessing/solids/" + std::string(file) + ".csv"));
    EXPECT_FALSE(folder.has("constant/solidSpheres"));
}

// The same seed makes the same bytes, another seed another bed; the spheres' file is what constant/geometry includes.
TEST(Bed, SameSeedSameBytes)
{
    const auto dict = "count 30;\nseed 5;\ncontainer { type box; min (0 0 0); max (0.04 0.04 0.1); }\nsize { value 0.01; }\n";
    const TestCase a(withRocks(dict)), b(withRocks(dict)), c(withRocks(dict));
    c.replace("system/packParticlesDict", "seed 5", "seed 6");
    for (const auto* each : {&a, &c}) each->runWell("packParticles", "-solids");
    b.runWell("packParticles", "-solids", 2); // threads
    EXPECT_EQ(difference(a.files("."), b.files(".")), "");
    EXPECT_NE(a.read("constant/solidSpheres"), c.read("constant/solidSpheres"));

    a.write("constant/geometry", "dimension 3; domain { min (0.01 0.01 0.005); max (0.03 0.03 0.015); periodic (); }\n"
                                 "walls { bed { type spheres; #include \"solidSpheres\" } }\n");
    a.write("constant/phaseProperties", "phases (water); water { rho 1000; }\n");
    // The default support: images of images in a crevice that have no weight are not made, else a particle there has 1900 neighbours and is refused.
    a.write("system/sphSchemes", "resolution { spacing 0.001; }\n");
    const auto out = a.runWell("packParticles");
    EXPECT_NE(out.find("30 spheres a cell"), std::string::npos) << out;
    // As settled they overlap by some 1e-5 of their size, and meshToGhost refuses the wedge of fluid between two that do.
    a.write("system/controlDict", "endTime 2e-4;\n");
    a.write("constant/phaseProperties", "phases (water); water { rho 1000; mu 1e-3; soundSpeed 5; }\n");
    a.runWell("meshToGhost");
    a.runWell("sphFoamLike");
}

// Spheres that are pushed apart reach the porosity asked for, without overlap; without one, that of random close packing: 0.36 (Scott & Kilgour
// 1969), with six contacts each at the point of jamming (O'Hern et al. 2003), less those that rattle. 0.63 to 0.64 of 150 spheres scatters by
// one percent.
TEST(Bed, RandomClose)
{
    const std::string box =
        "method randomClose;\ncontainer { type box; min (0 0 0); max (1 1 1); periodic (x y z); }\nsize { value 0.2; }\n";
    const auto given = pack(withRocks(box + "porosity 0.42;\n"));
    double solid = 0;
    for (const auto& b : given.bed.bodies) solid += std::numbers::pi / 6 * std::pow(b.size, 3);
    EXPECT_NEAR(1 - solid, 0.42, 1e-5);
    EXPECT_EQ(given.bed.overlap, 0);
    const auto least = pack(withRocks(box));
    EXPECT_EQ(least.bed.overlap, 0);
    EXPECT_NEAR(least.measures.porosity, 0.365, 0.015);
    EXPECT_GT(least.measures.coordination, 5.4);
    EXPECT_LT(least.measures.coordination, 6.4);
    const auto apart = pack(withRocks(box + "shrink 0.03;\n")).bed; // the same bed with gaps
    ASSERT_EQ(apart.bodies.size(), least.bed.bodies.size());
    EXPECT_EQ(apart.contacts.size(), least.bed.contacts.size());
    for (std::size_t i = 0; i < apart.bodies.size(); ++i)
    {
        EXPECT_NEAR(apart.bodies[i].size, 0.97 * least.bed.bodies[i].size, 1e-15);
        EXPECT_EQ(apart.bodies[i].centre.x, least.bed.bodies[i].centre.x);
    }
    const auto inCylinder =
        pack(withRocks("method randomClose;\nporosity 0.5;\ncontainer { type cylinder; base (0 0 0); radius 0.5; height 1; }\n"
                       "size { value 0.2; }\n"));
    EXPECT_EQ(inCylinder.bed.overlap, 0);
}

// Sizes have the distribution asked for: a lognormal's median and deviation, a list's shares by mass.
TEST(Bed, Sizes)
{
    const auto bodies = [](const std::string& size)
    {
        const TestCase folder(withRocks("count 1000;\ncontainer { type box; min (0 0 0); max (1 1 1); }\nsize { " + size + " }\n"));
        return drawBodies(readSolidsPlan(Case(folder.folder())), 1000);
    };
    double sum = 0, squares = 0;
    for (const auto& b : bodies("distribution lognormal; median 0.01; geometricStandardDeviation 1.3; min 0.001; max 0.1;"))
    {
        const double log = std::log(b.size / 0.01);
        sum += log;
        squares += log * log;
    }
    EXPECT_NEAR(sum / 1000, 0, 1e-6);
    EXPECT_NEAR(std::sqrt(squares / 1000), std::log(1.3), 2e-3);
    double small = 0, all = 0;
    for (const auto& b : bodies("distribution list; sizes (0.01 0.02); fractions (0.25 0.75);"))
    {
        all += std::pow(b.size, 3);
        if (b.size < 0.015) small += std::pow(b.size, 3);
    }
    EXPECT_NEAR(small / all, 0.25, 1e-3);
}

// Distributions of the mass. The sizes of n grains each have the mean volume of their part, so that the mass that is finer than a size is met but for the one grain
// that the size lies in.
TEST(Bed, SizesByMass)
{
    const auto sizesOf = [](const std::string& size)
    {
        const TestCase folder(withRocks("count 10;\ncontainer { type box; min (0 0 0); max (1 1 1); }\nsize { " + size + " }\n"));
        return readSolidsPlan(Case(folder.folder())).size;
    };
    const auto finer = [](const std::vector<double>& grains, double d)
    {
        double below = 0, all = 0;
        for (const double each : grains)
        {
            all += std::pow(each, 3);
            if (each <= d) below += std::pow(each, 3);
        }
        return below / all;
    };
    const auto rosin = sizesOf("distribution RosinRammler; d 0.01; n 1.2; min 0.004; max 0.03;");
    const auto grains = rosin.ofGrains(2000);
    double massOfAll = 0;
    for (const double d : grains) massOfAll += std::pow(d, 3);
    const double coarsest = std::pow(grains.back(), 3) / massOfAll;
    const auto share = [](double d) { return 1 - std::exp(-std::pow(d / 0.01, 1.2)); };
    for (const double d : {0.005, 0.007, 0.01, 0.02})
    {
        const double expected = (share(d) - share(0.004)) / (share(0.03) - share(0.004));
        EXPECT_NEAR(rosin.passing(d), expected, 1e-12);
        EXPECT_NEAR(finer(grains, d), expected, coarsest);
    }
    EXPECT_TRUE(std::ranges::is_sorted(grains));
    EXPECT_GE(grains.front(), 0.004);
    EXPECT_LE(grains.back(), 0.03);
    // The mean volume is that of the distribution, whatever their number: int dM/d^3 by a rule of its own.
    double perVolume = 0;
    constexpr int steps = 200'000;
    for (int k = 0; k < steps; ++k)
    {
        const double a = 0.004 + 0.026 * k / steps, b = 0.004 + 0.026 * (k + 1) / steps;
        perVolume += (share(b) - share(a)) / std::pow(0.5 * (a + b), 3) / (share(0.03) - share(0.004));
    }
    for (const int n : {10, 2000}) EXPECT_NEAR(rosin.meanVolume(n) * perVolume / (std::numbers::pi / 6), 1, 1e-5) << n;

    const std::string table = "passing ((0.002 0) (0.004 0) (0.0056 0.12) (0.008 0.44) (0.0112 0.81) (0.016 1) (0.02 1));";
    const auto sieved = sizesOf("distribution sieves; " + table);
    EXPECT_EQ(sieved.low, 0.004); // below and above there are no sizes
    EXPECT_EQ(sieved.high, 0.016);
    EXPECT_NEAR(sieved.passing(std::sqrt(0.0056 * 0.008)), 0.28, 1e-12); // linear in the logarithm
    for (const auto& [d, expected] : std::vector<std::pair<double, double>>{{0.0056, 0.12}, {0.008, 0.44}, {0.0112, 0.81}})
        EXPECT_NEAR(finer(sieved.ofGrains(2000), d), expected, 0.005);

    // A lognormal distribution of the mass is one of the number whose median is smaller by exp(-3 (ln s)^2) (Hatch & Choate 1929).
    const double s = 1.2, median = 0.01 * std::exp(-3 * std::pow(std::log(s), 2));
    const auto byMass =
        sizesOf("distribution lognormal; median 0.01; geometricStandardDeviation 1.2; min 0.001; max 0.1; fractionsOf mass;")
            .ofGrains(1001);
    EXPECT_NEAR(byMass[500] / median, 1, 1e-3);
}

// Shares of the mass of shapes are met but for a grain, whatever the sizes.
TEST(Bed, SharesOfMass)
{
    const TestCase folder(withRocks(
        "count 300;\ncontainer { type box; min (0 0 0); max (1 1 1); }\nsharesOf mass;\nshapes ( { share 0.2; } { file \"angular.obj\"; share "
        "0.7; } { file \"flat.obj\"; share 0.1; } );\nsize { distribution RosinRammler; d 0.01; n 1; min 0.002; max 0.03; }\n"));
    std::array<double, 3> mass{};
    double all = 0;
    Largest largest;
    for (const auto& b : drawBodies(readSolidsPlan(Case(folder.folder())), 300))
    {
        const double volume = std::pow(b.size, 3);
        mass[std::size_t(b.shape)] += volume;
        all += volume;
        largest(volume);
    }
    EXPECT_NEAR(mass[0] / all, 0.2, largest.value() / all);
    EXPECT_NEAR(mass[1] / all, 0.7, largest.value() / all);
    EXPECT_NEAR(mass[2] / all, 0.1, largest.value() / all);
}

// A bed of a height: as many solids as that takes, those with centres above taken away, so that it is level there and the sizes stay those of the sieves.
TEST(Bed, OfAHeight)
{
    const auto [plan, bed, m] =
        pack(withRocks("height 0.05;\nfriction 0.1;\ncontainer { type box; min (0 0 0); max (0.05 0.05 0.15); periodic (x y); }\n"
                       "size { distribution sieves; passing ((0.005 0) (0.0071 0.4) (0.01 1)); }\n"));
    EXPECT_GT(bed.takenAway, 0);
    double solid = 0, fine = 0;
    for (const auto& b : bed.bodies)
    {
        EXPECT_LE(b.centre.z, 0.05);
        solid += std::pow(b.size, 3);
        if (b.size < 0.0071) fine += std::pow(b.size, 3);
    }
    EXPECT_NEAR(fine / solid, 0.4, 0.05); // some 200 grains at the surface stay or go
    // Level: the volume of the solids is that of the middle half, up to the height.
    EXPECT_NEAR(std::numbers::pi / 6 * solid / ((1 - m.porosity) * 0.05 * 0.05 * 0.05), 1, 0.06);
}

// A bed that is tapped becomes as dense as it was asked to be, and no denser than a tap makes it.
TEST(Bed, Tapped)
{
    const std::string box =
        "count 100;\nfriction 0.3;\ncontainer { type box; min (0 0 0); max (0.04 0.04 0.15); periodic (x y); }\nsize { value 0.01; }\n";
    const auto poured = pack(withRocks(box));
    const double target = poured.measures.porosity - 0.004;
    const auto tapped = pack(withRocks(box + "porosity " + std::to_string(target) + ";\n"));
    EXPECT_GT(tapped.bed.taps, 0);
    EXPECT_LE(tapped.measures.porosity, target + 1e-4); // spheres are shrunk by less than that
    EXPECT_GT(tapped.measures.porosity, target - 0.01);
    EXPECT_LT(tapped.bed.kineticEnergy, 1e-6);
    EXPECT_LT(tapped.bed.overlap, 1e-3);
}

SolidContainer uprightCylinder(double radius)
{
    SolidContainer c;
    c.isCylinder = true;
    c.radius = radius;
    c.height = 1;
    return c;
}

// The solid in all shells together is that of the bed: of one sphere anywhere, cut by a height or about the axis, to 2e-4, and of a settled bed, whose exact porosity is that of its slices.
TEST(Bed, RadialPorosity)
{
    const auto c = uprightCylinder(0.3);
    Bed one;
    one.shapes.resize(1);
    one.meanSize = 0.1;
    const auto solidOf = [&](const std::vector<RadialShell>& shells, double height)
    {
        double sum = 0;
        const double thickness = c.radius / double(shells.size());
        for (const auto& shell : shells) sum += (1 - shell.porosity) * 2 * std::numbers::pi * shell.radius * thickness * height;
        return sum;
    };
    const double sphere = std::numbers::pi / 6 * 0.001;
    for (const double x : {0.0, 0.01, 0.05, 0.1234, 0.25})
    {
        one.bodies = {{0, 0.1, {0, x, 0.5}, {}}};
        EXPECT_NEAR(solidOf(radialPorosity(c, one, 0, 1), 1) / sphere, 1, 2e-4) << x;
        EXPECT_NEAR(solidOf(radialPorosity(c, one, 0.5, 1), 0.5) / sphere, 0.5, 1e-3) << x;
    }
    // At its wall a bed has nothing but points of contact, and half a diameter from it about a quarter of void (Benenati & Brosilow 1962).
    const auto [plan, bed, m] = pack(withRocks(cylinder));
    double area = 0, mean = 0;
    for (const auto& shell : m.shells)
    {
        area += shell.radius;
        mean += shell.radius * shell.porosity;
        EXPECT_EQ(shell.error, 0);
    }
    EXPECT_NEAR(mean / area, m.porosity, 2e-4);
    EXPECT_GT(m.shells.back().porosity, 0.9);
    EXPECT_LT(m.shells[m.shells.size() - 11].porosity, 0.35);
}

// With meshes the profile is sampled: the volume of a rock in all shells together is its own within four standard errors.
TEST(Bed, RadialPorosityByPoints)
{
    const auto c = uprightCylinder(0.2);
    Bed bed;
    bed.shapes.resize(2);
    bed.meanSize = 0.1;
    bed.shapes[1].mesh = makeRock(rockKinds()[0], 80, 1, 1);
    const auto moments = volumeMoments(bed.shapes[1].mesh);
    const double size = std::cbrt(6 / std::numbers::pi * moments.volume);
    for (auto& p : bed.shapes[1].mesh.points) p = (p - moments.centroid) / size;
    bed.shapes[1].reach = 1;
    bed.bodies = {{1, 0.1, {0.1, 0, 0.5}, {}}};
    double sum = 0, variance = 0;
    const auto shells = radialPorosity(c, bed, 0.4, 0.6);
    for (const auto& shell : shells)
    {
        const double volume = 2 * std::numbers::pi * shell.radius * c.radius / double(shells.size()) * 0.2;
        sum += (1 - shell.porosity) * volume;
        variance += std::pow(shell.error * volume, 2);
    }
    EXPECT_NEAR(sum, std::numbers::pi / 6 * 0.001, 4 * std::sqrt(variance));
    EXPECT_LT(std::sqrt(variance) / sum, 0.05);
}

// Gaps to the nearest sphere, contacts, and the tilt of rods: one upright, one lying.
TEST(Bed, GrainsAreMeasured)
{
    Bed bed;
    bed.shapes.resize(2);
    bed.meanSize = 1;
    bed.shapes[1].mesh = makeRock(*std::ranges::find(rockKinds(), "elongated", &RockKind::name), 80, 1, 1);
    SolidContainer c;
    c.length = c.width = c.height = 10;
    c.periodic = {true, false, false};
    bed.bodies = {{0, 1, {0.2, 5, 5}, {}}, {0, 1, {9.15, 5, 5}, {}}, {0, 1, {5, 5, 5}, {}}, {1, 1, {5, 2, 5}, {}}, {1, 1, {5, 8, 5}, {}}};
    bed.contacts = {{0, 1, 0.05}};
    BedMeasures m;
    measureGrains(c, bed, 2, 8, m);
    EXPECT_NEAR(m.grains[0].gap.value(), 0.05, 1e-12); // across the period
    EXPECT_NEAR(m.grains[1].gap.value(), 0.05, 1e-12);
    EXPECT_FALSE(m.grains[2].gap);
    EXPECT_EQ(m.grains[0].contacts, 1);
    EXPECT_NEAR(m.coreCoordination.value(), 2.0 / 5, 1e-12);
    EXPECT_FALSE(m.grains[0].tilt);
    const double tilt = m.grains[3].tilt.value();
    EXPECT_EQ(tilt, m.grains[4].tilt);
    // Turned about y by the angle that is left, a rod whose axis lies in the plane of x and z is upright: three rods along the axes have no order.
    const auto order = m.orientation.value();
    EXPECT_NEAR(order, 1.5 * std::pow(std::cos(tilt * std::numbers::pi / 180), 2) - 0.5, 1e-9);
    const double third = std::numbers::pi / 3, k = std::sin(third) / std::sqrt(3.0);
    const Rotation once{std::cos(third), {k, k, k}}; // x to y to z to x
    bed.bodies = {{1, 1, {5, 5, 5}, {}}, {1, 1, {5, 5, 5}, once}, {1, 1, {5, 5, 5}, once * once}};
    bed.contacts.clear();
    measureGrains(c, bed, 2, 8, m);
    EXPECT_NEAR(m.orientation.value(), 0, 1e-12);
    EXPECT_NEAR(m.orientationError, 1 / std::sqrt(15.0), 1e-12);
}

// Two unit cubes that overlap by a tenth do so whichever way they lie, and cubes apart do not.
TEST(Bed, OverlapIsMeasured)
{
    TriangleSurface cube;
    for (const auto& c : corners(Box{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}})) cube.points.push_back(c);
    for (const auto& f :
         std::vector<std::array<int, 4>>{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}})
    {
        cube.triangles.push_back({f[0], f[2], f[1]});
        cube.triangles.push_back({f[0], f[3], f[2]});
    }
    if (volumeMoments(cube).volume < 0)
        for (auto& t : cube.triangles) std::swap(t[0], t[1]);
    Bed bed;
    bed.shapes.resize(1);
    bed.shapes[0].mesh = cube;
    bed.shapes[0].reach = std::sqrt(0.75);
    SolidContainer c;
    c.length = c.width = c.height = 10;
    bed.bodies = {{0, 1, {3, 3, 3}, {}}, {0, 1, {3.9, 3.3, 3.2}, {}}};
    EXPECT_NEAR(largestOverlap(c, bed), 0.1, 1e-12);
    bed.bodies[1].centre = {4.01, 3.3, 3.2};
    EXPECT_EQ(largestOverlap(c, bed), 0);
    bed.bodies[1] = {0, 1, {3.9, 3, 3}, {std::cos(0.3), {0, 0, std::sin(0.3)}}};
    EXPECT_GT(largestOverlap(c, bed), 0.1);
    bed.bodies[1].centre = {9.6, 5, 5};
    bed.bodies[1].rotation = {};
    EXPECT_NEAR(largestOverlap(c, bed), 0.1, 1e-12);
}

// Each mistake has its file and line, and says what is possible.
TEST(Bed, Mistakes)
{
    const std::string box = "container { type box; min (0 0 0); max (0.1 0.1 0.1); }\n", size = "size { value 0.01; }\n";
    const auto says = [](const std::string& error, const std::string& what) {
        EXPECT_NE(error.find(what), std::string::npos) << what << "\nin\n" << error;
    };
    const std::string file = "system/packParticlesDict:";
    says(errorOf("count 0;\n" + box + size), file + "3: count 0: 1 to a million solids can be packed");
    says(errorOf(box + size), file + "1: entry \"count\" is missing in \"solids\"");
    says(errorOf("count 2000;\n" + box + size), file + "3: 2000 solids have 0.00105 m^3, and the container has 0.001 m^3");
    says(errorOf("count 5;\n" + box + "size { value 0.2; }\n"), "solids of 0.2 m do not fit into a container of 0.1 m");
    says(
        errorOf(
            "count 5;\ncontainer { type box; min (0 0 0); max (0.02 0.02 0.2); }\nshapes ( { file \"elongated.obj\"; } );\nsize { value 0.019; }\n"),
        file + "4: the largest solid (constant/triSurface/elongated.obj) is ");
    says(errorOf("count 5;\n" + box + "shapes ( { file \"missing.obj\"; } );\n" + size),
         file + "5: constant/triSurface/missing.obj is missing");
    auto open = makeRock(rockKinds()[0], 80, 1, 1);
    open.triangles.pop_back();
    says(errorOf("count 5;\n" + box + "shapes ( { file \"open.obj\"; } );\n" + size,
                 {{"constant/triSurface/open.obj", objText({{"a", open}})}}),
         file + "5: constant/triSurface/open.obj is no closed surface: 3 of its edges");
    auto inverted = makeRock(rockKinds()[0], 80, 1, 1);
    for (auto& t : inverted.triangles) std::swap(t[0], t[1]);
    says(errorOf("count 5;\n" + box + "shapes ( { file \"in.obj\"; } );\n" + size,
                 {{"constant/triSurface/in.obj", objText({{"a", inverted}})}}),
         "its normals must point outwards");
    says(errorOf("count 5;\n" + box + "shapes ( { file \"bad.obj\"; } );\n" + size,
                 {{"constant/triSurface/bad.obj", "v 0 0 0\nf 1 2 3\n"}}),
         "constant/triSurface/bad.obj: line 2: the face has the vertex 2, and there are 1");
    says(errorOf("count 5;\ncontainer { type box; min (0 0 0); max (0.025 0.1 0.1); periodic (x); }\nshapes ( { file \"flat.obj\"; } );\n" +
                 size),
         "a period of 0.025 m is shorter than two of the largest solid (constant/triSurface/flat.obj");
    says(errorOf("count 5;\ncontainer { type box; min (0 0 0); max (0.1 0.1 0.1); periodic (z); }\n" + size),
         "along gravity a bed that settles does not repeat");
    says(errorOf("count 5;\n" + box + size, {{"constant/g", "value (0 -7 -7);\n"}}),
         "constant/g:1: gravity is along no edge of the container");
    const auto sieves = [&](const std::string& passing)
    { return errorOf("count 5;\n" + box + "size { distribution sieves; passing (" + passing + "); }\n"); };
    says(sieves("(0.004 0) (0.008 0.5) (0.012 0.4) (0.016 1)"),
         file + "5: row 3: 0.4 passes 0.012 m, and 0.5 the finer sieve of 0.008 m: what passes must grow from row to row");
    says(sieves("(0.008 0) (0.004 1)"), "row 2: the sieve of 0.004 m follows one of 0.008 m: list them from the finest to the coarsest");
    says(sieves("(0.004 0) (0.008 50) (0.016 100)"), "the shares are in percent: write 1 for 100");
    says(sieves("(0.004 0.1) (0.008 1)"), "0.1 passes the finest sieve, of 0.004 m: add a row with the size that nothing passes, and 0");
    says(sieves("(0.004 0) (0.008 0.9)"), "0.9 passes the coarsest sieve, of 0.008 m: add a row with the size that all passes, and 1");
    says(sieves("(0.004 0) (0.008)"), "row 2 has 1 numbers: a sieve [m] and the share that passes it are needed");
    says(errorOf("count 5;\n" + box + "size { distribution list; sizes (0.01 0.02); fractions (0.5 0.6); }\n"),
         file + "5: fractions must not be negative, and their sum must be 1: it is 1.1");
    says(errorOf("count 5;\n" + box + "size { distribution RosinRammler; d 1e-5; n 2; min 0.01; max 0.02; }\n"),
         "the distribution has nothing between min 0.01 and max 0.02");
    says(errorOf("count 5;\n" + box + "size { value 10; }\n"),
         "solids of 10 m do not fit into a container of 0.1 m: are the sizes in mm? Lengths are in m");
    says(errorOf("count 5;\n" + box + "sharesOf mass;\nshapes ( { share 0.5; } { file \"flat.obj\"; share 0.6; } );\n" + size),
         file + "6: the shares of the shapes are 1.1 together: with sharesOf their sum must be 1; without it they are weights");
    says(errorOf("count 5;\nheight 0.05;\n" + box + size),
         file + "3: the height decides on the number of solids: leave out count or height");
    says(errorOf("height 0.2;\n" + box + size), file + "3: the bed cannot be 0.2 m high in a container of 0.1 m");
    says(errorOf("method randomClose;\nporosity 0.3;\n" + box + "size { value 0.03; }\n"), file + "4: spheres still overlap by");
    says(errorOf("count 20;\ncontainer { type box; min (0 0 0); max (0.02 0.02 0.045); }\n" + size),
         "stand out of it. With \"level yes;\"");
    says(errorOf("count 30;\ntimeLimit 1;\n" + box + size), file + "4: the bed is not at rest after 1 sqrt(d/g)");
    says(errorOf("count 5;\nfricton 1;\n" + box + size), file + "4: entry \"fricton\" is not used here. Did you mean \"friction\"?");
    const auto fines = [&](const std::string& entries)
    { return errorOf("count 5;\n" + box + "shapes ( { file \"flat.obj\"; fines { " + entries + " } } );\n" + size); };
    says(fines("massShare 0.3; min 0.05;"), file + "5: a grain takes 3429 fines of these sizes; 300 are possible");
    says(fines("massShare 30; min 0.1;"), file + "5: massShare 30 is none of 0 to 0.5");
    says(fines("massShare 0.1; min 0.3; max 0.2;"), file + "5: max 0.2 is less than min 0.3");
    says(fines("massShare 0.1; min 0.3; file \"missing.obj\";"), file + "5: constant/triSurface/missing.obj is missing");
    const TestCase none(Files{{"system/packParticlesDict", "lattice cubic;\n"}});
    says(none.run("packParticles", "-solids").err, "has no section \"solids\"");
}

// A bed lies where gravity draws it: at the top of a box upside down, and along the axis of a tilted cylinder from its base on.
TEST(Bed, LiesWhereGravityDrawsIt)
{
    auto files = withRocks("count 12;\ncontainer { type box; min (0.1 0.2 0.3); max (0.14 0.25 0.4); }\nsize { value 0.01; }\n");
    files["constant/g"] = "value (0 0 9.81);\n";
    const auto hanging = pack(files);
    for (const auto& b : hanging.bed.bodies)
    {
        const auto x = hanging.plan.container.toWorld(b.centre);
        EXPECT_GT(x.z, 0.37);
        EXPECT_LT(x.z, 0.395 + 1e-5);
        EXPECT_GT(x.x, 0.105 - 1e-5);
        EXPECT_LT(x.x, 0.135 + 1e-5);
        EXPECT_GT(x.y, 0.205 - 1e-5);
        EXPECT_LT(x.y, 0.245 + 1e-5);
    }
    files = withRocks("count 12;\ncontainer { type cylinder; base (1 0 0); radius 0.02; height 0.1; }\nsize { value 0.01; }\n");
    files["constant/g"] = "value (0 -3 -4);\n";
    const auto tilted = pack(files);
    for (const auto& b : tilted.bed.bodies)
    {
        const auto x = tilted.plan.container.toWorld(b.centre) - Vector<3>{1, 0, 0};
        const double above = dot(x, Vector<3>{0, 0.6, 0.8});
        EXPECT_GT(above, 0.005 - 1e-5);
        EXPECT_LT(above, 0.03);
        EXPECT_LT(mag(x - above * Vector<3>{0, 0.6, 0.8}), 0.015 + 1e-5);
    }
}

// What stands out of the top is taken away where that is asked for.
TEST(Bed, Level)
{
    const auto [plan, bed, m] =
        pack(withRocks("count 40;\nlevel yes;\ncontainer { type box; min (0 0 0); max (0.03 0.03 0.04); }\nsize { value 0.01; }\n"));
    EXPECT_GT(bed.takenAway, 0);
    EXPECT_EQ(int(bed.bodies.size()) + bed.takenAway, 40);
    for (const auto& b : bed.bodies) EXPECT_LE(b.centre.z + 0.5 * b.size, 0.04);
    for (const auto& [i, j, gap] : bed.contacts)
        EXPECT_LT(mag(bed.bodies[std::size_t(i)].centre - bed.bodies[std::size_t(j)].centre), 0.0101);
}

}
