// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/usda_reader.h"

#include <memory>

#include <gtest/gtest.h>

#include "core/io/usd_text.h"
#include "tests/core/io/soup_checks.h"

namespace toile::test {
namespace {

/// A shirt of two squares under two transforms, as USD's programs write it, with what a reader has
/// to pass over.
constexpr const char* kShirt = R"(#usda 1.0
(
    "exported by \"hand\""
    defaultPrim = "shirt"
    metersPerUnit = 0.01
    customLayerData = { string a = "}" }
    upAxis = "Y"
)

def Xform "shirt" (
    kind = "component"
    prepend apiSchemas = ["MaterialBindingAPI"]
)
{
    double3 xformOp:translate = (0, 10, 0)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    rel material:binding = </shirt/looks/denim>
    custom token note
    def Mesh "front" ( active = true )
    {
        float3[] extent = [(0, 0, 0), (1, 1, 0)]
        int[] faceVertexCounts = [4]
        int[] faceVertexIndices = [0, 1, 2, 3]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
        texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (
            interpolation = "vertex"
        )
        double3 xformOp:scale = (2, 2, 2)
        float xformOp:rotateZ = 90
        uniform token[] xformOpOrder = ["xformOp:rotateZ", "xformOp:scale"]
    }
    def Mesh "back" {
        uniform token orientation = "leftHanded"
        int[] faceVertexCounts = [3, 3]
        int[] faceVertexIndices = [0, 1, 2, 0, 2, 3]
        point3f[] points = [(0, 0, 5), (1, 0, 5), (1, 1, 5), (0, 1, 5)]
        texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (9, 9)] (
            interpolation = "faceVarying"
        )
        int[] primvars:st:indices = [0, 1, 2, 0, 2, 3]
        def GeomSubset "collar"
        {
            uniform token elementType = "face"
            int[] indices = [1]
            rel material:binding = </shirt/looks/rib>
        }
    }
    def Mesh "hidden" { token visibility = "invisible" }
    variantSet "size" = { "s" { def Mesh "x" {} } }
    def Scope "looks" { def Material "denim" {} }
}
over "elsewhere" { int a = 1 }
)";

Result<PolygonSoup> readText(const std::string& text) {
    Progress progress;
    return readUsd(std::make_shared<const std::string>(text), "a.usda", progress);
}

std::string withMesh(const std::string& content, const std::string& metadata = "") {
    return "#usda 1.0\n(" + metadata + ")\ndef Mesh \"m\" {\nint[] faceVertexCounts = [3]\n" +
           "int[] faceVertexIndices = [0, 1, 2]\n" +
           "point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]\n" + content + "}\n";
}

void expectAt(const Eigen::Vector3d& position, double x, double y, double z) {
    EXPECT_TRUE(position.isApprox(Eigen::Vector3d(x, y, z), 1e-12)) << position.transpose();
}

TEST(UsdReader, TakesMeshesWithNamesMaterialsAndUnit) {
    const auto soup = readText(kShirt);
    ASSERT_TRUE(soup) << sentence(soup.error());
    expectValid(*soup);
    EXPECT_EQ(soup->objects, (std::vector<std::string>{"front", "back"}));
    EXPECT_EQ(soup->faceObject, (std::vector<int>{0, 1, 1}));
    EXPECT_EQ(soup->materials, (std::vector<std::string>{"denim", "rib"}));
    EXPECT_EQ(soup->faceMaterial, (std::vector<int>{0, 0, 1}));
    ASSERT_TRUE(soup->statedUnit);
    EXPECT_EQ(soup->statedUnit->unit, LengthUnit::Centimetre);
}

TEST(UsdReader, PlacesByAllTransformsAndTurnsLeftHandedFaces) {
    const auto soup = readText(kShirt);
    ASSERT_TRUE(soup);
    expectAt(soup->positions[1], 0, 12, 0);  // twice as large, then turned, then moved
    expectAt(soup->positions[2], -2, 12, 0);
    EXPECT_EQ(face(*soup, 1), (std::vector<int>{6, 5, 4}));
}

TEST(UsdReader, TextureCoordinatesHangTogetherAtOnePosition) {
    const auto soup = readText(kShirt);
    ASSERT_TRUE(soup);
    EXPECT_EQ(soup->uvs.size(), 8U);
    EXPECT_EQ(soup->cornerUvs[4], soup->cornerUvs[8]);  // position 6 of both triangles
}

TEST(UsdReader, EveryOperationHasItsPlace) {
    struct {
        const char* ops;
        Eigen::Vector3d second;  ///< where (1, 0, 0) comes to lie
    } cases[] = {
        {"float3 xformOp:rotateXYZ = (0, 0, 90)\nuniform token[] xformOpOrder = "
         "[\"xformOp:rotateXYZ\"]\n",
         {0, 1, 0}},
        {"float3 xformOp:rotateXYZ = (90, 0, 90)\nuniform token[] xformOpOrder = "
         "[\"xformOp:rotateXYZ\"]\n",
         {0, 1, 0}},
        {"float3 xformOp:rotateZYX = (90, 0, 90)\nuniform token[] xformOpOrder = "
         "[\"xformOp:rotateZYX\"]\n",
         {0, 0, 1}},
        {"quatf xformOp:orient = (0.5, 0.5, 0.5, 0.5)\nuniform token[] xformOpOrder = "
         "[\"xformOp:orient\"]\n",
         {0, 1, 0}},
        {"matrix4d xformOp:transform = ((0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), (5, 6, 7, 1))\n"
         "uniform token[] xformOpOrder = [\"xformOp:transform\"]\n",
         {5, 7, 7}},
        {"float3 xformOp:translate:pivot = (1, 0, 0)\nfloat3 xformOp:scale = (3, 3, 3)\n"
         "uniform token[] xformOpOrder = [\"xformOp:translate:pivot\", \"xformOp:scale\", "
         "\"!invert!xformOp:translate:pivot\"]\n",
         {1, 0, 0}},
    };
    for (const auto& [ops, second] : cases) {
        const auto soup = readText(withMesh(ops));
        ASSERT_TRUE(soup) << ops << sentence(soup.error());
        expectAt(soup->positions[1], second.x(), second.y(), second.z());
    }
    EXPECT_FALSE(readText(withMesh("uniform token[] xformOpOrder = [\"xformOp:spin\"]\n")));
}

TEST(UsdReader, MirroredFacesAreTurnedBack) {
    const auto soup = readText(withMesh(
        "float3 xformOp:scale = (-1, 1, 1)\nuniform token[] xformOpOrder = [\"xformOp:scale\"]\n"));
    ASSERT_TRUE(soup);
    EXPECT_EQ(face(*soup, 0), (std::vector<int>{2, 1, 0}));
}

TEST(UsdReader, UnitAndUpAxisAreTheFiles) {
    const auto up = readText(withMesh("", "upAxis = \"Z\"\nmetersPerUnit = 0.001"));
    ASSERT_TRUE(up);
    expectAt(up->positions[2], 0, 1, 0);  // as written
    EXPECT_EQ(up->statedUp->axis, UpAxis::Z);
    EXPECT_EQ(up->statedUnit->unit, LengthUnit::Millimetre);
    const auto unstated = readText(withMesh(""));
    ASSERT_TRUE(unstated);
    EXPECT_EQ(unstated->statedUnit->unit, LengthUnit::Centimetre);
    EXPECT_EQ(unstated->statedUp->axis, UpAxis::Y);
    const auto feet = readText(withMesh("", "metersPerUnit = 0.3048"));
    ASSERT_TRUE(feet);
    EXPECT_EQ(feet->statedUnit->unit, LengthUnit::Metre);
    expectAt(feet->positions[1], 0.3048, 0, 0);
}

TEST(UsdReader, SaysThatACageIsReadWithoutSubdivision) {
    for (const char* scheme : {"", "uniform token subdivisionScheme = \"loop\"\n"}) {
        const auto cage = readText(withMesh(scheme));
        ASSERT_TRUE(cage);
        ASSERT_EQ(cage->problems.size(), 1U);
        const std::string said = cage->problems.front().detail;
        EXPECT_NE(said.find("subdivision is not applied"), std::string::npos) << said;
    }
    const auto plain = readText(withMesh("uniform token subdivisionScheme = \"none\"\n"));
    ASSERT_TRUE(plain);
    EXPECT_TRUE(plain->problems.empty());
}

TEST(UsdReader, OfMovingTransformsTheFirstMomentCounts) {
    const auto soup = readText(
        "#usda 1.0\ndef Mesh \"a\" ( prepend references = @./Bob's shirt).usda@ ) {\n"
        " int[] faceVertexCounts = [3]\n int[] faceVertexIndices = [0, 1, 2]\n"
        " point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]\n"
        " double3 xformOp:translate.timeSamples = { 0: (0, 0, 3), 1: (0, 0, 9) }\n"
        " float xformOp:rotateZ.timeSamples = { 0: 90, 1: 0 }\n"
        " uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateZ\"]\n}\n");
    ASSERT_TRUE(soup) << sentence(soup.error());
    EXPECT_LT((soup->positions[1] - Eigen::Vector3d(0, 1, 3)).norm(), 1e-9);
}

TEST(UsdReader, OfMovingMeshesTheFirstMomentCounts) {
    const auto soup = readText(
        "#usda 1.0\ndef Mesh \"m\" {\nint[] faceVertexCounts = [3]\n"
        "int[] faceVertexIndices = [0, 1, 2]\npoint3f[] points.timeSamples = {\n"
        "1: [(0, 0, 0), (4, 0, 0), (0, 1, 0)],\n2: [(0, 0, 0), (5, 0, 0), (0, 1, 0)],\n}\n}\n");
    ASSERT_TRUE(soup) << sentence(soup.error());
    expectAt(soup->positions[1], 4, 0, 0);
}

TEST(UsdReader, RefusesWithTheReason) {
    for (const std::string& text :
         {std::string(), std::string("PXR-USDC"), std::string("#usda 1.0\ndef Mesh \"m\" {"),
          std::string("#usda 1.0\ndef Mesh \"m\" {}"), withMesh("int[] faceVertexCounts = [4]\n"),
          withMesh("int[] faceVertexCounts = [-1]\n"), withMesh("point3f[] points = [(0, 0)]\n"),
          withMesh("point3f[] points = [(a, b, c)]\n"),
          withMesh("int[] faceVertexCounts = [2000000000, 2000000000]\n")}) {
        const auto soup = readText(text);
        ASSERT_FALSE(soup) << text;
        EXPECT_EQ(soup.error().code, ErrorCode::MalformedFile) << text;
        EXPECT_EQ(soup.error().subject.name, "a.usda");
        EXPECT_FALSE(soup.error().detail.empty());
    }
    EXPECT_EQ(readText("#usda 1.0\ndef Xform \"m\" {}").error().code, ErrorCode::NoGeometry);
}

TEST(UsdReader, EveryPrefixIsReadOrRefused) {
    const std::string text = kShirt;
    for (std::size_t length = 0; length < text.size(); ++length) {
        if (const auto soup = readText(text.substr(0, length))) {
            expectValid(*soup);
        }
    }
    std::string deep = "#usda 1.0\n";
    for (int k = 0; k < 100000; ++k) {
        deep += "def Xform \"a\" {";
    }
    EXPECT_FALSE(readText(deep));
}

TEST(UsdReader, FacesOnPointsThatAreNotThereAreLeftOut) {
    const auto soup = readText(
        "#usda 1.0\ndef Mesh \"m\" {\nint[] faceVertexCounts = [3, 3]\n"
        "int[] faceVertexIndices = [0, 1, 2, 0, 1, 7]\n"
        "point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]\n}\n");
    ASSERT_TRUE(soup);
    EXPECT_EQ(soup->faceCount(), 1);
    EXPECT_EQ(soup->problems.front().code, ErrorCode::IndexOutOfRange);
}

}  // namespace
}  // namespace toile::test
