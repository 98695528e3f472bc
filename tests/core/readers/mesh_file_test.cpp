// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/mesh_file.h"

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

std::string usdWith(const std::string& index, const std::string& vertex) {
    return "#usda 1.0\ndef Xform \"t\" { def Scope \"garment\" { def Mesh \"m\" { points = "
           "[(0,0,0),(1,0,0),(0,1,0)] faceVertexIndices = [0,1," +
           index +
           "] } } def Scope \"pattern\" { } def Scope \"seams\" { def S \"s\" { rel toile:left = "
           "</t/garment/m> int[] toile:leftVertices = [" +
           vertex + "] rel toile:right = </t/garment/m> int[] toile:rightVertices = [0] } } }";
}

TEST(ReadUsda, RefusesIndicesThatAreNone) {
    ASSERT_TRUE(readUsda(usdWith("2", "2")));
    EXPECT_EQ(readUsda(usdWith("2", "2"))->seams.front().mesh[0], "m");
    for (const char* number : {"3", "-1", "1e300", "nan"}) {
        EXPECT_FALSE(readUsda(usdWith(number, "2"))) << number;
        EXPECT_FALSE(readUsda(usdWith("2", number))) << number;
    }
}

/// A file whose JSON says this; nothing else is in it.
std::string glbOf(const std::string& json) {
    const auto word = [](std::size_t value) {
        std::string bytes;
        for (int k = 0; k < 4; ++k) {
            bytes += static_cast<char>(value >> (8 * k) & 0xFF);
        }
        return bytes;
    };
    return "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json;
}

TEST(ReadGlb, TakesJsonThatIsNestedDeeperThanAStack) {
    const std::string deep = std::string(2'000'000, '[') + std::string(2'000'000, ']');
    EXPECT_FALSE(readGlb(glbOf("{\"meshes\":" + deep + "}")));
    EXPECT_FALSE(readGlb(glbOf(R"({"scenes":[{"extras":{"toile_seams":)" + deep + "}}]}")));
}

TEST(ReadGlb, RefusesManyMeshesOfTheSameBytes) {
    const auto seed = [](const char* file) {
        return *readFile(test::sourceFile("tests/fuzz/seeds/glb") / file);
    };
    ASSERT_TRUE(readGlb(seed("one_mesh.glb")));
    EXPECT_FALSE(readGlb(seed("one_buffer_often.glb")));
}

}  // namespace
}  // namespace toile
