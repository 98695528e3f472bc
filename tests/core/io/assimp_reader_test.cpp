// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/assimp_reader.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/base/id.h"
#include "core/io/gltf_buffers.h"
#include "core/toile/pipeline.h"
#include "tests/core/io/soup_checks.h"
#include "tests/core/io/zip_archive.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile::test {
namespace {

/// Two triangles that make a unit square, six vertices. Nodes: "front", moved by (1, 2, 3) and
/// twice as large; its child "lining" in the same place, whose triangles lie apart in the UV map;
/// "back", mirrored in x.
constexpr const char* kGltf =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
"nodes": [
  {"name": "front", "mesh": 0, "translation": [1, 2, 3], "scale": [2, 2, 2], "children": [1]},
  {"name": "lining", "mesh": 1, "translation": [0, 0, 0]},
  {"name": "back", "mesh": 0, "scale": [-1, 1, 1]}],
"meshes": [
  {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]},
  {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 2}}]}],
"materials": [{"name": "denim"}],
"accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3",
   "min": [0, 0, 0], "max": [1, 1, 0]},
  {"bufferView": 1, "componentType": 5126, "count": 6, "type": "VEC2"},
  {"bufferView": 2, "componentType": 5126, "count": 6, "type": "VEC2"}],
"bufferViews": [
  {"buffer": 0, "byteLength": 72},
  {"buffer": 0, "byteOffset": 72, "byteLength": 48},
  {"buffer": 0, "byteOffset": 120, "byteLength": 48}],
"buffers": [{"byteLength": 168, "uri": "data:application/octet-stream;base64,)"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAAAAAAAAAAACAPwAAgD8AAAAAAAAA"
    "AAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAgD8AAIA/AAAAAAAAAAAAAIA/AACAPwAAAAAAAIA/AAAAAAAA"
    "AAAAAIA/AAAAAAAAgD8AAIA/AACgQAAAAAAAAMBAAACAPwAAoEAAAIA/"
    R"("}]})";

/// A rectangle of 30 cm by 20 cm as one quad, on a node that is moved up by a metre.
constexpr const char* kCollada = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count="12">0 0 0 30 0 0 30 20 0 0 20 0</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4</vcount>
<p>0 1 2 3</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n" name="yoke">
<translate>0 100 0</translate><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

std::string fbxWithUnit(const std::string& centimetres, const std::string& more = "") {
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n FBXHeaderVersion: 1003\n"
           " FBXVersion: 7400\n}\nGlobalSettings:  {\n Version: 1000\n Properties70:  {\n"
           "  P: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," +
           centimetres + more +
           "\n }\n}\nObjects:  {\n Geometry: 1001, \"Geometry::\", \"Mesh\" {\n  Vertices: *12 {\n"
           "   a: 0,0,0,10,0,0,10,10,0,0,10,0\n  }\n  PolygonVertexIndex: *4 {\n   a: 0,1,2,-4\n"
           "  }\n  GeometryVersion: 124\n }\n Model: 1002, \"Model::yoke\", \"Mesh\" {\n"
           "  Version: 232\n }\n}\nConnections:  {\n C: \"OO\",1001,1002\n C: \"OO\",1002,0\n}\n";
}

std::string bytesOfFloats(const std::vector<float>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

class AssimpReader : public testing::Test {
protected:
    Result<PolygonSoup> readAs(const std::string& fileName, const std::string& text) {
        Progress progress;
        return readSoup(folder_.write(fileName, text), progress);
    }

    TemporaryFolder folder_;
};

TEST_F(AssimpReader, MakesAnObjectOfEveryNodeThatHasAMesh) {
    const Result<PolygonSoup> soup = readAs("a.gltf", kGltf);
    ASSERT_TRUE(soup) << sentence(soup.error());
    expectValid(soup.value());
    EXPECT_EQ(soup.value().objects, (std::vector<std::string>{"front", "lining", "back"}));
    EXPECT_EQ(soup.value().faceObject, (std::vector<int>{0, 0, 1, 1, 2, 2}));
    EXPECT_EQ(soup.value().materials, std::vector<std::string>{"denim"});
    EXPECT_EQ(soup.value().faceMaterial, (std::vector<int>{0, 0, -1, -1, 0, 0}));
    EXPECT_TRUE(soup.value().problems.empty());
}

TEST_F(AssimpReader, SaysWhichAxisIsUp) {
    const auto up = [this](const std::string& fileName, const std::string& text) {
        const Result<PolygonSoup> soup = readAs(fileName, text);
        return soup ? soup->statedUp : std::nullopt;
    };
    const auto property = [](int axis) {
        return "\n  P: \"UpAxis\", \"int\", \"Integer\", \"\"," + std::to_string(axis);
    };
    EXPECT_EQ(up("a.gltf", kGltf)->axis, UpAxis::Y);
    EXPECT_EQ(up("a.dae", kCollada)->axis, UpAxis::Y);
    EXPECT_EQ(up("y.fbx", fbxWithUnit("1", property(1)))->axis, UpAxis::Y);
    EXPECT_EQ(up("z.fbx", fbxWithUnit("1", property(2)))->axis, UpAxis::Z);
    EXPECT_EQ(up("z.fbx", fbxWithUnit("1", property(2)))->reason, "stated in the FBX file");
    EXPECT_FALSE(up("x.fbx", fbxWithUnit("1", property(0))));  // it is not read as one of these
}

TEST_F(AssimpReader, MergesPositionsWithinAnObjectAndNeverAcross) {
    const Result<PolygonSoup> soup = readAs("a.gltf", kGltf);
    ASSERT_TRUE(soup);
    EXPECT_EQ(soup.value().positions.size(), 12U);  // four for each of the three squares
    EXPECT_EQ(face(soup.value(), 0), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(face(soup.value(), 1), (std::vector<int>{0, 2, 3}));
    EXPECT_EQ(face(soup.value(), 3), (std::vector<int>{4, 6, 7}));
}

TEST_F(AssimpReader, IslandsOfTheUvMapHangTogetherByIndex) {
    const Result<PolygonSoup> soup = readAs("a.gltf", kGltf);
    ASSERT_TRUE(soup);
    EXPECT_EQ(soup.value().uvs.size(), 4U + 6U + 4U);  // the lining's diagonal is a seam
    const std::vector<int>& uvs = soup.value().cornerUvs;
    EXPECT_EQ(std::vector<int>(uvs.begin(), uvs.begin() + 6), (std::vector<int>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(std::vector<int>(uvs.begin() + 6, uvs.begin() + 12),
              (std::vector<int>{4, 5, 6, 7, 8, 9}));
}

TEST_F(AssimpReader, PlacesObjectsAndTurnsMirroredFacesBack) {
    const Result<PolygonSoup> soup = readAs("a.gltf", kGltf);
    ASSERT_TRUE(soup);
    const auto& at = soup.value().positions;
    EXPECT_EQ(at[0], Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(at[2], Eigen::Vector3d(3, 4, 3));
    EXPECT_EQ(at[6], at[2]);  // a child is placed by its parent
    const std::vector<int> corners = face(soup.value(), 4);
    EXPECT_EQ(at[corners[0]], Eigen::Vector3d(-1, 1, 0));
    EXPECT_EQ(at[corners[1]], Eigen::Vector3d(-1, 0, 0));
    EXPECT_EQ(at[corners[2]], Eigen::Vector3d(0, 0, 0));
}

TEST_F(AssimpReader, GltfIsInMetres) {
    Progress progress;
    const Result<Garment> garment = loadGarment({folder_.write("a.gltf", kGltf)}, {}, progress);
    ASSERT_TRUE(garment) << sentence(garment.error());
    EXPECT_EQ(garment.value().files[0]->unit, LengthUnit::Metre);
    EXPECT_EQ(garment.value().files[0]->unitReason, "glTF files are in metres");
    EXPECT_EQ(garment.value().pieces[0]->mesh.V(0, 1), 2000);
}

TEST_F(AssimpReader, AVrmIsReadAsAGlb) {
    // A binary glTF is a header, the JSON, and the buffer.
    std::string json = kGltf;
    const std::size_t uri = json.find(R"(, "uri")");
    json.replace(uri, json.find('}', uri) - uri, "");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string buffer =
        bytesOfFloats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1,
                       0, 1, 1, 0, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1, 5, 0, 6, 1, 5, 1});
    const auto word = [](std::size_t number) {
        return bytesOf(static_cast<std::uint32_t>(number));
    };
    const std::string glb = "glTF" + word(2) + word(28 + json.size() + buffer.size()) +
                            word(json.size()) + "JSON" + json + word(buffer.size()) +
                            std::string("BIN\0", 4) + buffer;
    const auto binary = readAs("a.glb", glb), avatar = readAs("a.VRM", glb);
    ASSERT_TRUE(binary) << sentence(binary.error());
    ASSERT_TRUE(avatar) << sentence(avatar.error());
    expectSameMesh(*avatar, *binary);
    EXPECT_EQ(avatar->objects, binary->objects);
}

TEST_F(AssimpReader, ColladaKeepsPolygonsAndStatesItsUnit) {
    const Result<PolygonSoup> soup = readAs("a.dae", kCollada);
    ASSERT_TRUE(soup) << sentence(soup.error());
    expectValid(soup.value());
    EXPECT_EQ(soup.value().objects, std::vector<std::string>{"yoke"});
    EXPECT_EQ(face(soup.value(), 0), (std::vector<int>{0, 1, 2, 3}));
    EXPECT_TRUE(soup.value().positions[2].isApprox(Eigen::Vector3d(0.3, 1.2, 0), 1e-6));
    ASSERT_TRUE(soup.value().statedUnit);
    EXPECT_EQ(soup.value().statedUnit->unit, LengthUnit::Metre);
}

TEST_F(AssimpReader, FbxStatesItsUnitInCentimetres) {
    const std::pair<const char*, LengthUnit> units[] = {{"0.1", LengthUnit::Millimetre},
                                                        {"1", LengthUnit::Centimetre},
                                                        {"100", LengthUnit::Metre},
                                                        {"2.54", LengthUnit::Inch}};
    for (const auto& [centimetres, unit] : units) {
        const Result<PolygonSoup> soup = readAs("a.fbx", fbxWithUnit(centimetres));
        ASSERT_TRUE(soup) << sentence(soup.error());
        ASSERT_TRUE(soup.value().statedUnit) << centimetres;
        EXPECT_EQ(soup.value().statedUnit->unit, unit);
        EXPECT_EQ(soup.value().positions[2], Eigen::Vector3d(10, 10, 0));
    }
    const Result<PolygonSoup> feet = readAs("a.fbx", fbxWithUnit("30.48"));
    ASSERT_TRUE(feet);
    EXPECT_EQ(feet.value().statedUnit->unit, LengthUnit::Millimetre);
    EXPECT_NEAR(feet.value().positions[2].x(), 3048, 1e-3);
}

TEST_F(AssimpReader, SurvivesWhatItsLibraryDoesNot) {
    std::string noCount = kCollada;
    noCount.replace(noCount.find("count=\"12\""), 5, "c    ");
    EXPECT_FALSE(readAs("a.dae", noCount));
    // An entry that is not as long as the archive says.
    std::string archive =
        zipOf({{"_rels/.rels", "<Relationships/>"}, {"3D/3dmodel.model", "<m/>"}});
    archive[archive.find("<m/>") + 1] = 'n';
    EXPECT_FALSE(readAs("a.3mf", archive));
}

/// One triangle, its corners in a file beside it whose name has a space.
constexpr const char* kGltfWithBuffer =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"name": "yoke", "mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
               "min": [0, 0, 0], "max": [1, 1, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": "my%20yoke.bin"}]})";

TEST_F(AssimpReader, AGltfIsKnownByTheBytesOfItsBuffersToo) {
    const auto hashWith = [this](const std::vector<float>& corners) {
        folder_.write("my yoke.bin", bytesOfFloats(corners));
        const Result<PolygonSoup> soup = readAs("yoke.gltf", kGltfWithBuffer);
        EXPECT_TRUE(soup) << sentence(soup.error());
        return soup ? soup->contentHash.value_or(0) : 0;
    };
    const std::uint64_t first = hashWith({0, 0, 0, 1, 0, 0, 1, 1, 0});
    EXPECT_NE(hashWith({0, 0, 0, 1, 0, 0, 0, 1, 0}), first);
    EXPECT_EQ(hashWith({0, 0, 0, 1, 0, 0, 1, 1, 0}), first);
    // Without such a file it is that of the text, as of all formats.
    EXPECT_EQ(readAs("a.gltf", kGltf)->contentHash, contentHash(kGltf));
}

TEST_F(AssimpReader, AGltfMayNameButFilesInItsFolder) {
    const auto readWithBuffers = [this](const std::string& buffers) {
        return readAs("yoke.gltf",
                      R"({"asset": {"version": "2.0"}, "buffers": [)" + buffers + "]}");
    };
    const auto buffer = [](const std::string& uri) {
        return R"({"byteLength": 36, "uri": ")" + uri + R"("})";
    };
    // A pipe that nobody writes to has no end: to open it is to wait for ever.
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    for (const char* uri :
         {"/dev/zero", "../a.bin", "%2e%2e/a.bin", "b/../../a.bin", "pipe", "."}) {
        const auto refused = readWithBuffers(buffer(uri));
        ASSERT_FALSE(refused) << uri;
        EXPECT_EQ(refused.error().code, ErrorCode::FileUnreadable) << uri;
        EXPECT_EQ(refused.error().subject.name, "yoke.gltf");
        EXPECT_NE(sentence(refused.error()).find(uri), std::string::npos);
    }
    // Together they are bounded, and none is read for nothing.
    folder_.write("a.bin", "a");
    std::filesystem::resize_file(folder_.write("b.bin", "b"), io::kMaxBufferBytes);
    const auto tooLong = readWithBuffers(buffer("a.bin") + ", " + buffer("b.bin"));
    ASSERT_FALSE(tooLong);
    EXPECT_NE(sentence(tooLong.error()).find("2 GiB"), std::string::npos);
}

/// A triangle whose node is scaled by 100 and has a skin. Its joint stands 2 m high; the inverse
/// bind matrix moves by 1 m down. The last vertex has no weights.
std::string gltfWithSkin(const std::string& jointName) {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
"nodes": [{"name": "shirt", "mesh": 0, "skin": 0, "scale": [100, 100, 100]},
          {"name": "armature", "translation": [0, 2, 0], "children": [2]}, )" +
           jointName + R"(],
"skins": [{"joints": [2], "inverseBindMatrices": 3}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}]}],
"accessors": [
  {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
   "min": [0, 0, 0], "max": [1, 1, 0]},
  {"bufferView": 1, "componentType": 5121, "count": 3, "type": "VEC4"},
  {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC4"},
  {"bufferView": 3, "componentType": 5126, "count": 1, "type": "MAT4"}],
"bufferViews": [{"buffer": 0, "byteLength": 36},
                {"buffer": 0, "byteOffset": 36, "byteLength": 12},
                {"buffer": 0, "byteOffset": 48, "byteLength": 48},
                {"buffer": 0, "byteOffset": 96, "byteLength": 64}],
"buffers": [{"byteLength": 160, "uri": "skin.bin"}]})";
}

TEST_F(AssimpReader, ASkinPlacesItsMeshWithoutItsNode) {
    folder_.write("skin.bin", bytesOfFloats({0, 0, 0, 1, 0, 0, 1, 1, 0}) + std::string(12, '\0') +
                                  bytesOfFloats({1, 0, 0, 0, 0.5F, 0, 0, 0, 0, 0, 0, 0}) +
                                  bytesOfFloats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1}));
    const auto soup = readAs("skin.gltf", gltfWithSkin(R"({"name": "hips"})"));
    ASSERT_TRUE(soup) << sentence(soup.error());
    ASSERT_EQ(soup->positions.size(), 3U);
    EXPECT_EQ(soup->positions[0], Eigen::Vector3d(0, 1, 0));
    EXPECT_EQ(soup->positions[1], Eigen::Vector3d(1, 1, 0));  // weights need not sum to 1
    EXPECT_EQ(soup->positions[2], Eigen::Vector3d(1, 2, 0));
    // A joint that cannot be told from another node is no reason to guess.
    const auto unclear = readAs("skin.gltf", gltfWithSkin(R"({"name": "armature"})"));
    ASSERT_FALSE(unclear);
    EXPECT_NE(unclear.error().detail.find("joints"), std::string::npos);
    // A mesh of the same name as the joint is told from it.
    EXPECT_TRUE(readAs("skin.gltf", gltfWithSkin(R"({"name": "shirt"})")));
}

std::string threeMf(const std::string& attributes) {
    return zipOf(
        {{"_rels/.rels",
          R"(<Relationships><Relationship Target="/3D/3dmodel.model" Id="r" )"
          R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
         {"3D/3dmodel.model",
          "<?xml version=\"1.0\"?>\n<model " + attributes +
              R"( xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>
<object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="10" y="0" z="0"/>
<vertex x="0" y="30" z="0"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh>
</object></resources><build><item objectid="1"/></build></model>)"}});
}

TEST_F(AssimpReader, ThreeMfStatesItsUnitAndMeansMillimetresWithoutOne) {
    const std::pair<const char*, double> units[] = {
        {"unit=\"micron\"", 0.001}, {"unit=\"millimeter\"", 1}, {"unit=\"centimeter\"", 10},
        {"unit = \"meter\"", 1000}, {"unit='inch'", 25.4},      {"unit=\"foot\"", 304.8},
        {"xml:lang=\"en-US\"", 1}};
    for (const auto& [attribute, millimetres] : units) {
        const auto soup = readAs("a.3mf", threeMf(attribute));
        ASSERT_TRUE(soup) << sentence(soup.error());
        ASSERT_TRUE(soup->statedUnit);
        EXPECT_DOUBLE_EQ(soup->positions[2].y() * millimetresPer(soup->statedUnit->unit),
                         30 * millimetres)
            << attribute;
        ASSERT_TRUE(soup->statedUp);
        EXPECT_EQ(soup->statedUp->axis, UpAxis::Z);
    }
}

TEST_F(AssimpReader, SharedFilesHaveTheirTrueSize) {
    const std::pair<const char*, double> files[] = {{"3mf-unit/as_box.3mf", 30},
                                                    {"gltf-skin/gltf_plain.gltf", 400},
                                                    {"gltf-skin/gltf_skin_armature001.gltf", 400},
                                                    {"gltf-skin/gltf_skin_node_scaled.gltf", 400}};
    for (const auto& [name, millimetres] : files) {
        const auto path = sharedFile(std::string("reports/") + name);
        TOILE_NEEDS_SHARED(path);
        Progress progress;
        const auto soup = readSoup(path, progress);
        ASSERT_TRUE(soup) << sentence(soup.error());
        Eigen::AlignedBox3d box;
        for (const auto& position : soup->positions) {
            box.extend(position);
        }
        EXPECT_NEAR(box.sizes().maxCoeff() * millimetresPer(soup->statedUnit->unit), millimetres,
                    millimetres * 1e-5)
            << name;
    }
}

TEST_F(AssimpReader, APipeIsNotWaitedFor) {
    // In a .glb, too, whose buffers assimp alone looks at.
    ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
    std::string json =
        R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "pipe"}]})";
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t value) {
        const auto bits = static_cast<std::uint32_t>(value);
        return std::string(reinterpret_cast<const char*>(&bits), sizeof bits);
    };
    EXPECT_FALSE(readAs(
        "a.glb", "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json));
}

TEST_F(AssimpReader, RefusesWithAReason) {
    const Result<PolygonSoup> broken = readAs("a.glb", "no glTF at all");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().code, ErrorCode::MalformedFile);
    EXPECT_EQ(broken.error().subject.name, "a.glb");
    EXPECT_FALSE(broken.error().detail.empty());
    Progress progress;
    const Result<PolygonSoup> missing = readSoup("/nowhere/a.glb", progress);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::FileUnreadable);
    progress.cancel();
    const Result<PolygonSoup> cancelled = readSoup(folder_.write("b.gltf", kGltf), progress);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace toile::test
