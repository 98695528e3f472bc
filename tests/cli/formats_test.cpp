// SPDX-License-Identifier: GPL-3.0-or-later
// Files as strangers bring them, with the built program.
#include <cctype>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/id.h"
#include "core/project/project_file.h"
#include "tests/cli/run_program.h"
#include "tests/core/io/zip_archive.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

const std::string kSampleFolder = std::string(TOILE_SOURCE_DIR) + "/resources/samples/";

std::string sampleText(const std::string& name) {
    const Result<std::string> bytes = readFile(kSampleFolder + name);
    EXPECT_TRUE(bytes) << name;
    return bytes ? *bytes : "";
}

/// The report of a flattening without what names the file and the time.
nlohmann::json figuresOf(const std::string& input, const test::TemporaryFolder& folder) {
    const std::string report = (folder / "out.json").string();
    const auto run = test::toileRun({"flatten", input, "-o", report});
    EXPECT_EQ(run.status, 0) << run.err;
    const nlohmann::json said = nlohmann::json::parse(folder.read("out.json"));
    nlohmann::json figures = nlohmann::json::array();
    for (const auto& piece : said["pieces"]) {
        figures.push_back({piece["name"], piece["triangles"], piece["area_2d"],
                           piece["perimeter_2d"], piece["strain_max"]});
    }
    return figures;
}

TEST(Formats, AnArchiveGivesTheSamePatternAsItsFile) {
    const test::TemporaryFolder folder;
    const auto archive = folder.write(
        "bodice.zip",
        test::zipOf({{"bodice/", ""}, {"bodice/bodice.obj", sampleText("bodice.obj")}}));
    EXPECT_EQ(figuresOf(archive.string(), folder), figuresOf(kSampleFolder + "bodice.obj", folder));
}

TEST(Formats, AProjectKnowsAnArchiveAgain) {
    const test::TemporaryFolder folder;
    const std::string archive = test::zipOf({{"flap.obj", test::kPanel}});
    Project project;
    project.files = {{folder.write("flap.zip", archive), contentHash(archive)}};
    project.loading.unit = LengthUnit::Millimetre;
    ASSERT_TRUE(writeProject(folder / "flap.toile", project));
    const auto same = test::toileRun({"flatten", (folder / "flap.toile").string()});
    EXPECT_EQ(same.status, 0) << same.err;
    EXPECT_EQ(same.err, "");
    folder.write("flap.zip", test::zipOf({{"flap.obj", test::kTriangle}}));
    const auto other = test::toileRun({"flatten", (folder / "flap.toile").string()});
    EXPECT_NE(other.err.find("has changed since"), std::string::npos) << other.err;
}

TEST(Formats, OurOwnUsdTextComesBackAsTheGarmentItWas) {
    const test::TemporaryFolder folder;
    const std::string usd = (folder / "bodice.usda").string();
    ASSERT_EQ(test::toileRun({"flatten", kSampleFolder + "bodice.obj", "-o", usd}).status, 0);
    const auto run = test::toileRun({"info", usd, "--json"});
    const auto back = nlohmann::json::parse(run.out);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(back["files"][0]["unit"], "mm");
    const auto was =
        nlohmann::json::parse(test::toileRun({"info", kSampleFolder + "bodice.obj", "--json"}).out);
    ASSERT_EQ(back["pieces"].size(), was["pieces"].size());  // and not the pattern beside it
    for (std::size_t k = 0; k < was["pieces"].size(); ++k) {
        EXPECT_EQ(back["pieces"][k]["triangles"], was["pieces"][k]["triangles"]);
        EXPECT_NEAR(back["pieces"][k]["loops"][0], was["pieces"][k]["loops"][0], 0.05);
    }
    EXPECT_EQ(back["seams"].size(), was["seams"].size());
}

/// One triangle a metre wide, moved along x. @param metres  how far
std::string gltfAt(const std::string& metres) {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"name": "flap", "mesh": 0, "translation": [)" +
           metres +
           R"(, 0, 0]}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
"min": [0, 0, 0], "max": [1, 1, 0]}],
"bufferViews": [{"buffer": 0, "byteLength": 36}],
"buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
           R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAA"}]})";
}

TEST(Formats, SinglePrecisionIsNamedWhereItShows) {
    const test::TemporaryFolder folder;
    const auto near = test::toileRun({"info", folder.write("a.gltf", gltfAt("0")).string()});
    EXPECT_EQ(near.status, 0) << near.err;
    EXPECT_EQ(near.out.find("precision"), std::string::npos) << near.out;
    const auto far = test::toileRun({"info", folder.write("a.gltf", gltfAt("4000")).string()});
    EXPECT_NE(far.out.find("precise only to 0."), std::string::npos) << far.out;
}

TEST(Formats, BinaryUsdSaysWhatItIs) {
    const test::TemporaryFolder folder;
    for (const char* name : {"a.usdc", "a.usdz", "a.USD"}) {
        const auto run = test::toileRun({"info", folder.write(name, "PXR-USDC").string()});
        EXPECT_EQ(run.status, 3) << name;
        EXPECT_NE(run.err.find("save it as .usda"), std::string::npos) << run.err;
    }
}

TEST(Formats, UsdThatIsTextIsReadByEitherEnding) {
    const test::TemporaryFolder folder;
    const std::string text =
        "#usda 1.0\n(\n upAxis = \"Z\"\n)\ndef Mesh \"flap\" {\n int[] faceVertexCounts = [3]\n"
        " int[] faceVertexIndices = [0, 1, 2]\n point3f[] points = [(0, 0, 0), (50, 0, 0), (0, 0, "
        "30)]\n}\n";
    for (const char* name : {"a.usda", "a.usd"}) {
        const std::string file = folder.write(name, text).string();
        const auto run = test::toileRun({"info", file});
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_NE(run.out.find("up z (stated in the USD file)"), std::string::npos) << run.out;
        EXPECT_NE(run.out.find("500 x 300 x 0"), std::string::npos) << run.out;
        const auto other = test::toileRun({"info", file, "--up", "y"});
        EXPECT_NE(other.out.find("500 x 0 x 300"), std::string::npos) << other.out;
    }
}

class DesignedGarment : public testing::TestWithParam<const char*> {};

/// A designer's own division is never taken for what nobody could sew.
TEST_P(DesignedGarment, IsInNoDoubt) {
    const auto file = test::dataFile(GetParam());
    TOILE_NEEDS_SHARED(file);
    const auto run = test::toileRun({"flatten", file.string(), "--fail-on", "doubt"});
    // Two of the four panels of this file are wound the other way round.
    const bool isMixed = file.filename() == "skirt_clo.obj";
    const auto doubt = run.err.find("toile: doubt:");
    EXPECT_EQ(doubt != std::string::npos, isMixed) << run.err;
    EXPECT_EQ(run.err.find("toile: doubt:", doubt + 1), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("faces of the garment point inwards") != std::string::npos, isMixed);
    EXPECT_EQ(run.status, isMixed ? 1 : 0) << run.err;
}

INSTANTIATE_TEST_SUITE_P(Slow, DesignedGarment,
                         testing::Values("samples/tshirt.obj", "samples/skirt.obj",
                                         "samples/bodice.obj", "samples/trousers.obj",
                                         "garments/tee_sim.obj", "garments/dress.obj",
                                         "garments/polo.obj", "garments/longsleeve.obj",
                                         "garments/skirt_clo.obj", "garments/tshirt.obj"),
                         [](const auto& test) {
                             std::string name = test.param;
                             for (char& c : name) {
                                 c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                             }
                             return name;
                         });

}  // namespace
}  // namespace toile
