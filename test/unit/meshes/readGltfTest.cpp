/// glTF 2.0 as programs write it. Each file is a box of 2 x 1 x 0.5 = 1 m3.
#include "Imported.hpp"
#include "geometry/Shape.hpp"
#include "gltfTexts.hpp"
#include <gtest/gtest.h>

namespace sph::test::readGltfTest
{
using namespace std::string_literals;

namespace
{

const Mesh brick = box({-1, 0, 0.25}, {1, 1, 0.75});

std::string plain(const std::string& node = "", const std::string& more = "", const std::string& primitive = "")
{
    return embedded<float, std::uint16_t>(brick, 5126, 5123, "", node, more, primitive);
}

void expectBox(const Imported& i, double volume = 1, double tolerance = 0)
{
    EXPECT_EQ(i.refusal, "");
    EXPECT_NEAR(i.volume(), volume, tolerance);
    EXPECT_EQ(i.mesh.triangles.size(), 12u);
}

void expectRefusal(const std::string& text, const std::string& why) { EXPECT_EQ(Imported("a.gltf", text).refusal, why); }

}

// KHR_mesh_quantization: bytes and shorts, signed and not, as they are or normalized, with the scale of the node that brings them back.
TEST(ReadGltf, QuantizedPositions)
{
    const auto scaledBy = [](double k) { return fmt::format(R"(,"scale":[{0},{0},{0}])", 1 / k); };
    const auto grown = [](double k)
    {
        auto m = brick;
        for (auto& p : m.points) p = k * p;
        return m;
    };
    auto positive = grown(4);
    for (auto& p : positive.points) p.x += 4;
    expectBox(Imported("a.gltf", embedded<std::int8_t, std::uint8_t>(grown(100), 5120, 5121, "", scaledBy(100), quantization)), 1, 1e-14);
    expectBox(Imported("a.gltf", embedded<std::uint8_t, std::uint8_t>(positive, 5121, 5121, "", scaledBy(4), quantization)));
    expectBox(Imported("a.gltf", embedded<std::int16_t, std::uint16_t>(grown(20000), 5122, 5123, "", scaledBy(20000), quantization)), 1,
              1e-14);
    expectBox(Imported("a.gltf", embedded<std::uint16_t, std::uint32_t>(positive, 5123, 5125, "", scaledBy(4), quantization)));
    // Normalized: the largest number is 1.
    const std::string normalized = R"(,"normalized":true)";
    expectBox(Imported("a.gltf",
                       embedded<std::int8_t, std::uint8_t>(grown(100), 5120, 5121, normalized, scaledBy(100.0 / 127), quantization)),
              1, 1e-14);
    expectBox(Imported("a.gltf", embedded<std::uint8_t, std::uint8_t>(positive, 5121, 5121, normalized, scaledBy(4.0 / 255), quantization)),
              1, 1e-14);
    expectBox(Imported("a.gltf", embedded<std::int16_t, std::uint16_t>(grown(20000), 5122, 5123, normalized, scaledBy(20000.0 / 32767),
                                                                       quantization)),
              1, 1e-14);
    expectBox(Imported("a.gltf",
                       embedded<std::uint16_t, std::uint16_t>(positive, 5123, 5123, normalized, scaledBy(4.0 / 65535), quantization)),
              1, 1e-14);
    // -128 is -1 as well: the box ends where -127 would.
    auto low = grown(100);
    for (auto& p : low.points)
        if (p.x < 0) p.x = -128;
    const Imported clamped("a.gltf", embedded<std::int8_t, std::uint8_t>(low, 5120, 5121, normalized, "", quantization));
    EXPECT_DOUBLE_EQ(clamped.volume(), 227.0 / 127 * 100 / 127 * 50 / 127);
}

// Buffers beside the file, with percents in their names, within it, and of a .glb.
TEST(ReadGltf, Buffers)
{
    const auto bytes = data<float, std::uint16_t>(brick);
    const auto beside = [&](const std::string& uri) { return document(uri, bytes.size(), 5126, 4, 5123); };
    expectBox(Imported("a.gltf", beside("tank%20of%20%C3%BCber%25.bin"),
                       {{"tank of \xC3\xBC"
                         "ber%.bin",
                         bytes}}));
    expectBox(Imported("a.gltf", beside("parts/100%.bin"), {{"parts/100%.bin", bytes}}));
    expectBox(Imported("a.gltf", plain()));
    expectBox(Imported("a.glb", glb(beside(""), bytes)));
    expectBox(Imported("a.gltf", "\xEF\xBB\xBF\n" + plain()));
    const auto longer = glb(beside(""), bytes) + "more";
    const Imported i("a.glb", longer);
    expectBox(i);
    EXPECT_EQ(i.allNotes(), "4 bytes behind the length that its header tells of left out");
    expectRefusal(beside("none.bin"), "buffers[0].uri: \"none.bin\" cannot be read: No such file or directory");
    expectRefusal(beside("https://a.org/b.bin"), "buffers[0].uri: \"https://a.org/b.bin\" is not beside the file: export it with its data");
    expectRefusal(beside(""), "buffers[0]: it has no uri, and the file no binary part");
    EXPECT_EQ(Imported("a.glb", glb(beside(""), bytes.substr(0, 100))).refusal,
              "buffers[0].byteLength: 200, and 100 bytes are there: it is truncated");
    EXPECT_EQ(Imported("a.glb", glb(beside(""), bytes).substr(0, 400)).refusal.find("byte 8: its header tells of "), 0u);
}

// Nodes one in another, by matrix or by scale, rotation and translation; a mirror turns the facets, too, so that the volume stays positive.
TEST(ReadGltf, Nodes)
{
    expectBox(Imported("a.gltf", plain(R"(,"translation":[1,2,3],"scale":[2,2,2])")), 8);
    expectBox(Imported("a.gltf", plain(R"(,"scale":[-1,1,1])")));
    const Imported turned("a.gltf", plain(R"(,"rotation":[0,0,0.70710678,0.70710678],"translation":[10,0,0])"));
    expectBox(turned, 1, 1e-14);
    EXPECT_NEAR(boundingBox(turned.mesh).low.x, 9, 1e-15);
    EXPECT_NEAR(boundingBox(turned.mesh).high.y, 1, 1e-15);
    const Imported matrix("a.gltf", plain(R"(,"matrix":[0,2,0,0,-2,0,0,0,0,0,2,0,5,6,7,1])"));
    expectBox(matrix, 8);
    EXPECT_EQ(boundingBox(matrix.mesh).low, (Vector<3>{3, 4, 7.5}));
    auto nested =
        replaced(plain(R"(,"translation":[1,0,0])"), R"("nodes":[{"mesh":0)", R"("nodes":[{"children":[1],"scale":[3,1,1]},{"mesh":0)");
    const Imported inner("a.gltf", nested);
    expectBox(inner, 3);
    EXPECT_EQ(boundingBox(inner.mesh).high.x, 6);
    const auto unlisted = replaced(nested, R"("scene":0,"scenes":[{"nodes":[0]}],)", "");
    expectBox(Imported("a.gltf", unlisted), 3);
    expectRefusal(replaced(nested, R"("children":[1])", R"("children":[1,1])"), "nodes[1]: it has two parents");
    expectRefusal(replaced(nested, R"("children":[1])", R"("children":[0])"), "nodes[0]: it has two parents");
    expectRefusal(plain(R"(,"rotation":[0,0,0,0])"), "nodes[0].rotation: the quaternion is zero");
}

// Strips, fans, corners without indices, sparse changes; lines and points are told of.
TEST(ReadGltf, Primitives)
{
    // The triangles of the box without indices: 36 points.
    Mesh soup;
    for (const auto& t : brick.triangles)
        for (const int p : t) soup.points.push_back(brick.points[std::size_t(p)]);
    auto text = replaced(embedded<float, std::uint8_t>(soup, 5126, 5121), R"(,"indices":1)", "");
    text = replaced(replaced(text, R"("count":8)", R"("count":36)"), R"("byteLength":128)", R"("byteLength":576)");
    expectBox(Imported("a.gltf", text));
    // A tetrahedron of 1/6 m3 as a strip, and as a fan with its bottom as a strip: the same two accessors.
    Mesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}, {}, {}, {}}, {{0, 2, 1}, {3, 0, 2}}};
    auto strip = embedded<float, std::uint8_t>(tetrahedron, 5126, 5121, "", "", "", R"(,"mode":5)");
    const Imported strips("a.gltf", replaced(strip, R"("count":36)", R"("count":6)"));
    EXPECT_EQ(strips.refusal, "");
    EXPECT_EQ(strips.mesh.triangles.size(), 4u);
    EXPECT_DOUBLE_EQ(strips.volume(), 1.0 / 6);
    const Mesh fan{tetrahedron.points, {{3, 1, 2}, {0, 1, 0}}};
    const Imported fans("a.gltf", replaced(embedded<float, std::uint8_t>(fan, 5126, 5121, "", "", "", R"(,"mode":6)"), R"("count":36)",
                                           R"("count":5)"));
    EXPECT_EQ(fans.refusal, "");
    EXPECT_EQ(fans.mesh.triangles.size(), 3u);
    const Imported lines("a.gltf",
                         replaced(plain(), R"("primitives":[)", R"("primitives":[{"mode":1,"attributes":{}},{"mode":0,"attributes":{}},)"));
    expectBox(lines);
    EXPECT_EQ(lines.allNotes(), "2 primitives of lines or points left out");
    // Four points are moved by sparse changes: the box becomes 3 m long.
    std::string changes;
    for (const int p : {1, 3, 5, 7}) put(changes, std::uint8_t(p));
    for (const int p : {1, 3, 5, 7})
        for (const double x : {2.0, brick.points[std::size_t(p)].y, brick.points[std::size_t(p)].z}) put(changes, float(x));
    auto sparse = embedded<float, std::uint16_t>(
        brick, 5126, 5123,
        R"(,"sparse":{"count":4,"indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":2,"byteOffset":4}})");
    sparse = replaced(sparse, R"(],"buffers":[)", R"(,{"buffer":1,"byteLength":52}],"buffers":[)");
    sparse = replaced(sparse, R"("}]})", R"("},{"byteLength":52,"uri":"data:;base64,)" + base64(changes) + R"("}]})");
    expectBox(Imported("a.gltf", sparse), 1.5);
    expectRefusal(replaced(sparse, R"("bufferView":0,)", ""), "accessors[0]: it has no bufferView: sparse changes of nothing are not read");
}

// Extensions that change the geometry are refused by name, where they are required and where they are only used; those of looks are not.
TEST(ReadGltf, Extensions)
{
    for (const std::string name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing", "ACME_curves"})
        expectRefusal(plain("", fmt::format(R"(,"extensionsRequired":["{}"])", name)),
                      fmt::format("extensionsRequired[0]: the extension \"{}\" is not read: export it without (compression)", name));
    expectRefusal(plain("", "", R"(,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0}})"),
                  "meshes[0].primitives[0]: the extension \"KHR_draco_mesh_compression\" is not read: export it without (compression)");
    expectRefusal(replaced(plain(), R"({"buffer":0,)", R"({"extensions":{"EXT_meshopt_compression":{"buffer":0}},"buffer":0,)"),
                  "bufferViews[0]: the extension \"EXT_meshopt_compression\" is not read: export it without (compression)");
    expectRefusal(plain(R"(,"extensions":{"EXT_mesh_gpu_instancing":{}})"),
                  "nodes[0]: the extension \"EXT_mesh_gpu_instancing\" is not read: export it without (compression)");
    expectBox(Imported("a.gltf", plain("", R"(,"extensionsRequired":["KHR_materials_unlit","KHR_texture_transform"])")));
    expectRefusal(plain(R"(,"skin":0)"), "nodes[0].skin: skins are not read: apply its pose, and export it again");
    expectRefusal(plain(R"(,"weights":[0,0.5])"), "nodes[0].weights: morph targets are not read: apply them, and export it again");
}

// Each refusal says the line of the JSON or the path in it, what was found, and what was expected.
TEST(ReadGltf, Refusals)
{
    expectRefusal("hello", "it begins with neither glTF nor {: this is no glTF file");
    EXPECT_EQ(Imported("a.gltf", plain().substr(0, 300)).refusal.find("it is no JSON: it is truncated or damaged at line 1, column 301: "),
              0u);
    expectRefusal(replaced(plain(), "\"2.0\"", "\"1.0\""), "asset.version: glTF 1.0 is not read: export it as glTF 2.0");
    EXPECT_EQ(Imported("a.glb", "glTF\1\0\0\0"s).refusal, "byte 4: glTF 1 is not read: export it as glTF 2.0");
    EXPECT_EQ(Imported("a.glb", "glTF\2\0\0\0"s).refusal, "byte 8: it ends within its header: it is truncated");
    expectRefusal(replaced(plain(), R"("asset":{"version":"2.0"},)", ""), "\"asset\" is missing");
    expectRefusal(replaced(plain(), R"("count":36)", R"("count":35)"), "meshes[0].primitives[0]: 35 corners are no whole triangles");
    expectRefusal(replaced(plain(), R"("count":36)", R"("count":39)"),
                  "accessors[1]: 39 elements of 2 bytes from byte 0 on, every 2 bytes, do not fit in the 72 bytes of bufferViews[1]");
    expectRefusal(replaced(plain(), R"("count":36)", R"("count":4611686018427387905)"),
                  "accessors[1]: 4611686018427387905 elements of 2 bytes from byte 0 on, every 2 bytes, do not fit in the 72 bytes of "
                  "bufferViews[1]");
    expectRefusal(replaced(plain(), R"("count":36)", R"("count":-1)"), "accessors[1].count: expected a whole number");
    expectRefusal(replaced(plain(), R"("byteOffset":128)", R"("byteOffset":130)"),
                  "bufferViews[1]: bytes 130 to 202 of a buffer of 200: it is truncated or damaged");
    expectRefusal(replaced(plain(), R"("bufferView":1)", R"("bufferView":2)"), "bufferViews: there is no number 2 of 2");
    expectRefusal(replaced(plain(), R"("type":"VEC3")", R"("type":"VEC4")"), "accessors[0].type: expected VEC3, found VEC4");
    expectRefusal(replaced(plain(), "5123", "5130"), "accessors[1].componentType: 5130 is no type of numbers");
    auto far = brick;
    far.triangles[3][1] = 8;
    expectRefusal(embedded<float, std::uint16_t>(far, 5126, 5123), "meshes[0].primitives[0].indices: vertex 8, and there are 8");
    far = brick;
    far.points[2].y = std::numeric_limits<double>::quiet_NaN();
    expectRefusal(embedded<float, std::uint16_t>(far, 5126, 5123), "accessors[0]: element 2 is no finite number");
}

}
