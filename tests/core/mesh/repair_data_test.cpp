// SPDX-License-Identifier: GPL-3.0-or-later
/// Repairs on real files: what index.json counts, and what comes of it.
#include <fstream>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/soup.h"
#include "core/io/triangulate.h"
#include "core/mesh/weld.h"
#include "tests/core/mesh/repair_support.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

MeshPart readPart(const std::filesystem::path& path) {
    Progress progress;
    const Result<PolygonSoup> soup = readSoup(path, progress);
    EXPECT_TRUE(soup) << path;
    const Triangulation triangles = triangulate(*soup, path.filename().string());
    MeshArrays mesh;
    mesh.F = triangles.F;
    mesh.V.resize(static_cast<Eigen::Index>(soup->positions.size()), 3);
    for (std::size_t v = 0; v < soup->positions.size(); ++v) {
        mesh.V.row(static_cast<Eigen::Index>(v)) = soup->positions[v];
    }
    return test::asPart(std::move(mesh));
}

nlohmann::json indexEntry(const std::string& file) {
    std::ifstream stream(test::sharedFile("index.json"));
    for (const auto& entry : nlohmann::json::parse(stream)) {
        if (entry.value("file", "") == file) {
            return entry;
        }
    }
    return {};
}

/// What checkDisk says of each component: "disk" or a code, with how many say so.
std::map<std::string, int> outcomes(const MeshArrays& mesh) {
    std::map<std::string, int> counts;
    for (const MeshArrays& component : test::componentsOf(mesh)) {
        const DiskCheck check = checkDisk(component, "");
        ++counts[check.defect ? std::string(name(check.defect->code)) : "disk"];
    }
    return counts;
}

using Outcomes = std::map<std::string, int>;

struct Case {
    const char* file;
    const char* repairs;  ///< kinds
    Outcomes outcomes;
};

class RepairData : public testing::TestWithParam<Case> {};

TEST_P(RepairData, ComesOutAsAnOrientedManifold) {
    const auto path = test::sharedFile(GetParam().file);
    TOILE_NEEDS_SHARED(path);
    const MeshPart part = readPart(path);
    const RepairResult result = repair(part, "piece");
    EXPECT_EQ(test::kindsOf(result.repairs), GetParam().repairs);
    EXPECT_EQ(outcomes(result.part.mesh), GetParam().outcomes);
    test::expectOrientedManifold(result.part.mesh);
    test::expectSources(result.part, part.mesh);
    const nlohmann::json index = indexEntry(GetParam().file);
    EXPECT_EQ(test::countOf(result.repairs, ErrorCode::DuplicateFacesRemoved),
              index.value("duplicate_faces", 0));
    EXPECT_EQ(test::countOf(result.repairs, ErrorCode::UnusedVertices),
              index.value("unused_vertices", 0));
    EXPECT_EQ(
        test::countOf(result.repairs, ErrorCode::WindingsTurned) > 0 ||
            test::countOf(result.repairs, ErrorCode::EdgesCutApart) > 0,
        index.value("orientation_conflicts", 0) > 0 || index.value("nonmanifold_edges", 0) > 0);
    if (index.value("duplicate_faces", 0) == 0) {
        const double area = test::areaOf(part.mesh);
        EXPECT_NEAR(test::areaOf(result.part.mesh), area, 1e-12 * area);
        EXPECT_EQ(test::countOf(result.repairs, ErrorCode::EdgesCutApart),
                  index.value("nonmanifold_edges", 0));
        EXPECT_EQ(test::countOf(result.repairs, ErrorCode::VerticesSplit),
                  index.value("nonmanifold_vertices", 0));
        EXPECT_EQ(test::countOf(result.repairs, ErrorCode::EdgesCollapsed) +
                      test::countOf(result.repairs, ErrorCode::FlatFacesRemoved),
                  index.value("zero_area_triangles", 0));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Nasty, RepairData,
    testing::Values(
        Case{"nasty/fan3.obj", "windings-turned edges-cut-apart", {{"disk", 2}}},
        Case{"nasty/hourglass_ico.obj", "vertices-split", {{"closed-surface", 2}}},
        Case{"nasty/triple_vierbein.obj", "windings-turned edges-cut-apart", {{"disk", 3}}},
        Case{"nasty/inverted_triangles.obj", "windings-turned", {{"several-loops", 1}}},
        Case{"nasty/bunny_holes.ply",
             "unused-vertices duplicate-faces-removed windings-turned edges-cut-apart",
             {{"several-loops", 1}, {"disk", 68}}},
        Case{"nasty/capsule.obj", "edges-collapsed", {{"disk", 1}}},
        Case{"nasty/degtri_sliding.off", "flat-faces-removed", {{"disk", 1}}},
        Case{"nasty/panel_flipped.obj", "windings-turned", {{"disk", 1}}},
        Case{"nasty/panel_tiny.obj", "", {{"disk", 1}}},
        Case{"nasty/panel_far.obj", "", {{"disk", 1}}},
        Case{"garments/polo.obj", "windings-turned edges-cut-apart", {{"several-loops", 1}}}),
    [](const testing::TestParamInfo<Case>& test) {
        return std::filesystem::path(test.param.file).stem().string();
    });

TEST(RepairFiles, AllDegenLeavesNothing) {
    const auto path = test::sharedFile("nasty/all_degen.off");
    TOILE_NEEDS_SHARED(path);
    const RepairResult result = repair(readPart(path), "piece");
    EXPECT_EQ(test::kindsOf(result.repairs), "edges-collapsed flat-faces-removed");
    EXPECT_EQ(result.part.mesh.F.rows(), 0);
    EXPECT_EQ(result.part.mesh.V.rows(), 0);
}

TEST(RepairFiles, TheBunnyKeepsItsFiveHoles) {
    const auto path = test::sharedFile("nasty/bunny_holes.ply");
    TOILE_NEEDS_SHARED(path);
    const RepairResult result = repair(readPart(path), "bunny");
    const auto components = test::componentsOf(result.part.mesh);
    EXPECT_GT(components[0].F.rows(), 16000);
    EXPECT_TRUE(checkDisk(components[0], "bunny").defect->detail.starts_with("5 loops"));
}

TEST(RepairFiles, TheWeldedCapsuleIsClosed) {
    const auto path = test::sharedFile("nasty/capsule.obj");
    TOILE_NEEDS_SHARED(path);
    MeshPart part = readPart(path);
    const double area = test::areaOf(part.mesh);
    const Weld weld = findWeld(part.mesh.F, part.mesh.V, {});
    EXPECT_EQ(weld.merged, indexEntry("nasty/capsule.obj").value("duplicate_positions", 0));
    const RepairResult result = repair(test::applyWeld(std::move(part), weld), "capsule");
    test::expectOrientedManifold(result.part.mesh);
    EXPECT_EQ(outcomes(result.part.mesh), (Outcomes{{"closed-surface", 1}}));
    EXPECT_EQ(result.part.mesh.F.rows(), 10000);
    EXPECT_NEAR(test::areaOf(result.part.mesh), area, 1e-12 * area);
}

TEST(RepairFiles, WeldingFindsTheDoubledPositions) {
    for (const char* file : {"nasty/boeing.off", "nasty/mask_cone.off",
                             "nasty/elephant-with-holes.off", "nasty/panel_flipped.obj"}) {
        const auto path = test::sharedFile(file);
        TOILE_NEEDS_SHARED(path);
        const MeshPart part = readPart(path);
        const Weld weld = findWeld(part.mesh.F, part.mesh.V, {.borderOnly = false});
        EXPECT_EQ(weld.merged, indexEntry(file).value("duplicate_positions", -1)) << file;
        EXPECT_FALSE(looksUnwelded(part.mesh.F, part.mesh.V)) << file;
        const RepairResult result = repair(test::applyWeld(part, weld), file);
        test::expectOrientedManifold(result.part.mesh);
    }
}

}  // namespace
}  // namespace toile
