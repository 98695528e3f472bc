// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/shared_data.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/soup.h"
#include "core/io/triangulate.h"
#include "tests/core/io/soup_checks.h"

namespace toile::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Faces that the file counts and the reader leaves out: listed in the index, but for the one
/// record of two corners.
int leftOut(const json& entry) {
    return entry.value("faces_out_of_range", 0) +
           (entry["file"] == "nasty/notenoughindices.obj" ? 1 : 0);
}

void expectAsIndexed(const json& entry) {
    const std::string file = entry["file"];
    SCOPED_TRACE(file);
    Progress progress;
    const Result<PolygonSoup> soup = readSoup(dataFile(file), progress);
    const int faces = entry["faces"].get<int>() - leftOut(entry);
    if (faces == 0) {
        ASSERT_FALSE(soup);
        EXPECT_EQ(soup.error().code, ErrorCode::NoGeometry);
        return;
    }
    ASSERT_TRUE(soup) << soup.error().detail;
    expectValid(*soup);
    EXPECT_EQ(soup->positions.size(), entry["vertices"].get<std::size_t>());
    EXPECT_EQ(soup->faceCount(), faces);
    const auto nonFinite = std::count_if(soup->positions.begin(), soup->positions.end(),
                                         [](const auto& p) { return !p.allFinite(); });
    EXPECT_EQ(nonFinite, entry.value("nonfinite_vertices", 0));
    if (entry.contains("uv")) {
        EXPECT_EQ(soup->uvs.size(), entry["uv"]["vt"].get<std::size_t>());
    }
    const bool faultless = leftOut(entry) == 0 && nonFinite == 0;
    EXPECT_EQ(soup->problems.empty(), faultless);

    const Triangulation triangles = triangulate(*soup, file);
    if (faultless) {
        for (const Error& problem : triangles.problems) {
            EXPECT_EQ(problem.code, ErrorCode::PolygonNotSimple);
        }
        EXPECT_EQ(triangles.F.rows(), static_cast<Eigen::Index>(soup->corners.size()) -
                                          Eigen::Index{2} * soup->faceCount());
    }
}

TEST(SharedData, EveryMeshHasTheCountsOfTheIndex) {
    const fs::path index = sharedFile("index.json");
    TOILE_NEEDS_SHARED(index);
    std::ifstream file(index);
    int read = 0;
    for (const json& entry : json::parse(file)) {
        if (entry["kind"] == "garment" || entry["kind"] == "disk" || entry["kind"] == "nasty") {
            expectAsIndexed(entry);
            ++read;
        }
    }
    EXPECT_GT(read, 50);
}

/// The table of resources/samples/README.md.
TEST(Samples, EveryMeshHasTheCountsOfTheTable) {
    std::ifstream page(dataFile("samples/README.md"));
    const std::regex row(R"(^\| `([a-z]+\.obj)` \|.*\| ([0-9]+) \| ([0-9]+) \|$)");
    std::smatch match;
    int read = 0;
    for (std::string line; std::getline(page, line);) {
        if (std::regex_match(line, match, row)) {
            expectAsIndexed({{"file", "samples/" + match[1].str()},
                             {"vertices", std::stoi(match[2])},
                             {"faces", std::stoi(match[3])}});
            ++read;
        }
    }
    EXPECT_EQ(read, 5);
}

PolygonSoup soupOf(const fs::path& file) {
    Progress progress;
    Result<PolygonSoup> soup = readSoup(file, progress);
    return soup ? *soup : PolygonSoup();
}

TEST(SharedData, GroupNamesThatLookLikeFacesStayNames) {
    const fs::path file = sharedFile("nasty/face_in_group_name.obj");
    TOILE_NEEDS_SHARED(file);
    const PolygonSoup soup = soupOf(file);
    EXPECT_EQ(soup.groups, (std::vector<std::string>{"An f Three Other Things"}));
    EXPECT_EQ(soup.faceGroup, (std::vector<int>{-1, 0}));
}

TEST(SharedData, PiecesHaveTheirNames) {
    const fs::path file = sharedFile("garments/polo_pieces.obj");
    TOILE_NEEDS_SHARED(file);
    const PolygonSoup soup = soupOf(file);
    EXPECT_EQ(soup.objects.size() + soup.groups.size() + soup.materials.size(), 7u);
}

TEST(SharedData, PositionTextEndsBeforeTheLineEnd) {
    const fs::path file = sharedFile("garments/skirt_clo.obj");
    TOILE_NEEDS_SHARED(file);
    const PolygonSoup soup = soupOf(file);
    ASSERT_EQ(soup.positionText.size(), soup.positions.size());
    for (const TextSpan& span : soup.positionText) {
        ASSERT_GT(span.length, 4u);
        ASSERT_NE(soup.text->at(span.offset + span.length - 1), '\r');
    }
}

}  // namespace
}  // namespace toile::test
