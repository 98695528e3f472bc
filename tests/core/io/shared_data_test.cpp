// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <fstream>
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

const fs::path kData = TOILE_SHARED_DATA;

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
    const Result<PolygonSoup> soup = readSoup(kData / file, progress);
    const int faces = entry["faces"].get<int>() - leftOut(entry);
    if (faces == 0) {
        ASSERT_FALSE(soup);
        EXPECT_EQ(soup.error().code, ErrorCode::NoGeometry);
        return;
    }
    ASSERT_TRUE(soup) << soup.error().detail;
    expectSound(*soup);
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
    std::ifstream file(kData / "index.json");
    if (!file) {
        GTEST_SKIP() << (kData / "index.json");
    }
    int read = 0;
    for (const json& entry : json::parse(file)) {
        const fs::path mesh = kData / entry["file"].get<std::string>();
        const bool isMesh =
            entry["kind"] == "garment" || entry["kind"] == "disk" || entry["kind"] == "nasty";
        if (isMesh && fs::exists(mesh)) {
            expectAsIndexed(entry);
            ++read;
        }
    }
    EXPECT_GT(read, 0);
}

PolygonSoup soupOf(const char* file) {
    Progress progress;
    Result<PolygonSoup> soup = readSoup(kData / file, progress);
    return soup ? *soup : PolygonSoup();
}

TEST(SharedData, GroupNamesThatLookLikeFacesStayNames) {
    if (!fs::exists(kData / "nasty/face_in_group_name.obj")) {
        GTEST_SKIP() << "nasty/face_in_group_name.obj";
    }
    const PolygonSoup soup = soupOf("nasty/face_in_group_name.obj");
    EXPECT_EQ(soup.groups, (std::vector<std::string>{"An f Three Other Things"}));
    EXPECT_EQ(soup.faceGroup, (std::vector<int>{-1, 0}));
}

TEST(SharedData, PiecesHaveTheirNames) {
    if (!fs::exists(kData / "garments/polo_pieces.obj")) {
        GTEST_SKIP() << "garments/polo_pieces.obj";
    }
    const PolygonSoup soup = soupOf("garments/polo_pieces.obj");
    EXPECT_EQ(soup.objects.size() + soup.groups.size() + soup.materials.size(), 7u);
}

TEST(SharedData, PositionTextEndsBeforeTheLineEnd) {
    if (!fs::exists(kData / "garments/skirt_clo.obj")) {
        GTEST_SKIP() << "garments/skirt_clo.obj";
    }
    const PolygonSoup soup = soupOf("garments/skirt_clo.obj");
    ASSERT_EQ(soup.positionText.size(), soup.positions.size());
    for (const TextSpan& span : soup.positionText) {
        ASSERT_GT(span.length, 4u);
        ASSERT_NE(soup.text->at(span.offset + span.length - 1), '\r');
    }
}

}  // namespace
}  // namespace toile::test
