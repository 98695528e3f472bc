// SPDX-License-Identifier: GPL-3.0-or-later
// Proposed cuts are smooth, and alike on both sides of what is symmetric.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "core/assemble/cut_pieces.h"
#include "core/cut/surface_paths.h"
#include "core/geometry/segment.h"
#include "core/tailor/tailor_cuts.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/tailor/worn_shapes.h"

namespace toile {
namespace {

/// A shirt that is its own mirror image to the last bit, its vertices off the grid: lines of its
/// mesh say nothing.
MeshArrays mirroredTee() {
    MeshArrays mesh = test::wornShirt();
    std::map<std::array<double, 3>, int> vertexAt;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        vertexAt[{mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)}] = v;
    }
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    std::mt19937 random(5);
    const auto offset = [&random] { return static_cast<double>(random() % 1000) / 1000 - 0.5; };
    const Points3 before = mesh.V;
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (before(v, 0) >= 0 && links.isInner(v)) {
            const Eigen::RowVector3d by{12 * offset(), 12 * offset(), 4 * offset()};  // in order
            mesh.V.row(v) += before(v, 0) > 0 ? by : by.cwiseProduct(Eigen::RowVector3d(0, 1, 1));
            const int image = vertexAt.at({-before(v, 0), before(v, 1), before(v, 2)});
            mesh.V.row(image) = mesh.V.row(v).cwiseProduct(Eigen::RowVector3d(-1, 1, 1));
        }
    }
    return mesh;
}

/// Sum of the angles by which a line on the surface turns in space.
double turnOf(const MeshArrays& mesh, const std::vector<SurfacePoint>& line) {
    std::vector<Eigen::Vector3d> points;
    for (const SurfacePoint& point : line) {
        const Eigen::Vector3d at = positionOf(mesh, point);
        if (points.empty() || (at - points.back()).norm() > 1e-6) {
            points.push_back(at);
        }
    }
    double sum = 0;
    for (std::size_t i = 2; i < points.size(); ++i) {
        sum += geometry::angleBetween(points[i - 1] - points[i - 2], points[i] - points[i - 1]);
    }
    return sum;
}

/// Lines that are curves by what they are: round an arm or the waist, or where panels were sewn.
bool isCurve(const TailorCut& cut) {
    return cut.line == TailorLine::Armhole || cut.line == TailorLine::Waist ||
           cut.line == TailorLine::Style || cut.line == TailorLine::Band;
}

/// Where a line may have a corner: where another ends on it.
std::vector<std::size_t> jointsOf(const std::vector<SurfacePoint>& line, const MeshArrays& mesh,
                                  const std::vector<TailorCut>& cuts) {
    std::vector<std::size_t> joints{0};
    for (std::size_t k = 1; k + 1 < line.size(); ++k) {
        const Eigen::Vector3d at = positionOf(mesh, line[k]);
        if (std::ranges::any_of(cuts, [&at](const TailorCut& other) {
                return other.line != TailorLine::Style && other.line != TailorLine::Band &&
                       ((other.cut.points.front() - at).norm() < 1e-6 ||
                        (other.cut.points.back() - at).norm() < 1e-6);
            })) {
            joints.push_back(k);
        }
    }
    joints.push_back(line.size() - 1);
    return joints;
}

/// The eighths of a curve: what goes through them is its smooth form.
std::vector<std::size_t> eighthsOf(const std::vector<SurfacePoint>& line, const MeshArrays& mesh,
                                   double length) {
    std::vector<std::size_t> places{0};
    double way = 0;
    for (std::size_t k = 1; k + 1 < line.size(); ++k) {
        way += (positionOf(mesh, line[k]) - positionOf(mesh, line[k - 1])).norm();
        if (way * 8 >= length * static_cast<double>(places.size())) {
            places.push_back(k);
        }
    }
    places.push_back(line.size() - 1);
    return places;
}

/// Every proposed cut turns at most 1.5 times as much as the shortest way between its joints; a
/// curve as the shortest ways between its eighths, and their corners.
void expectNoSawTooth(const Piece& piece, const std::vector<TailorCut>& cuts) {
    const SurfaceLinks links(piece.mesh, piece.table);
    const NearestSurface nearest(piece.mesh);
    for (const TailorCut& cut : cuts) {
        const auto path = traceUserCut(links, nearest, cut.cut);
        ASSERT_TRUE(path) << cut.cut.name;
        const std::vector<SurfacePoint>& line = path->points;
        const std::vector<std::size_t> places = isCurve(cut)
                                                    ? eighthsOf(line, piece.mesh, path->length)
                                                    : jointsOf(line, piece.mesh, cuts);
        double turn = 0, smooth = 0;
        std::vector<SurfacePoint> whole;
        for (std::size_t k = 1; k < places.size(); ++k) {
            const std::vector<SurfacePoint> part(
                line.begin() + static_cast<std::ptrdiff_t>(places[k - 1]),
                line.begin() + static_cast<std::ptrdiff_t>(places[k]) + 1);
            turn += turnOf(piece.mesh, part);
            const auto shortest = geodesicPath(links, part.front(), part.back());
            ASSERT_TRUE(shortest) << cut.cut.name;
            smooth += turnOf(piece.mesh, shortest->points);
            whole.insert(whole.end(), shortest->points.begin(), shortest->points.end());
        }
        if (isCurve(cut)) {
            turn = turnOf(piece.mesh, line);
            smooth = turnOf(piece.mesh, whole);
        }
        EXPECT_LE(turn, 1.5 * smooth + 1e-3) << cut.cut.name;
    }
}

TEST(SmoothLines, OfOurShapesNoneIsASawTooth) {
    for (const MeshArrays& mesh :
         {test::wornShirt(), test::wornTrousers(), test::wornSkirt(), mirroredTee()}) {
        const auto piece = test::wornPiece(mesh);
        const std::vector<TailorCut> cuts = tailorCuts(piece);
        EXPECT_FALSE(cuts.empty());
        expectNoSawTooth(*piece, cuts);
    }
}

TEST(SmoothLines, OfGarmentsNoneIsASawTooth) {
    TOILE_NEEDS_SHARED(test::sharedFile("garments"));
    for (const char* file : {"tee_sim.obj", "tshirt.obj", "longsleeve.obj", "polo.obj", "dress.obj",
                             "leggings.ply", "suit_mh.obj"}) {
        SCOPED_TRACE(file);
        Progress progress;
        const auto garment = loadGarment({test::sharedFile(std::string("garments/") + file)},
                                         {.split = SplitMode::Components, .weld = true}, progress);
        ASSERT_TRUE(garment);
        const auto& piece = *std::ranges::max_element(
            garment->pieces, {}, [](const auto& one) { return one->mesh.F.rows(); });
        const std::vector<TailorCut> cuts = tailorCuts(piece);
        EXPECT_FALSE(cuts.empty());
        expectNoSawTooth(*piece, cuts);
    }
}

/// Of the cuts that are proposed beside a person's, those of the left are those of the right,
/// reflected.
void expectMirrored(const MeshArrays& mesh, const std::vector<UserCut>& own) {
    const auto piece = test::wornPiece(mesh);
    const auto body = readBody(piece);
    ASSERT_TRUE(body);
    std::vector<UserCut> cuts = own;
    for (const TailorCut& cut : tailorCuts(*piece, *body, own)) {
        cuts.push_back(cut.cut);
    }
    std::map<std::string, AppliedCut> made;
    for (const AppliedCut& cut : cutPieces({piece}, cuts, false, Progress()).cuts) {
        made[cut.name] = cut;
    }
    int pairs = 0;
    for (const auto& [name, left] : made) {
        if (!name.starts_with("left ")) {
            continue;
        }
        ASSERT_TRUE(made.contains("right " + name.substr(5))) << name;
        const AppliedCut& right = made.at("right " + name.substr(5));
        EXPECT_NEAR(left.length, right.length, 1e-6) << name;
        for (const Eigen::Vector3d& point : left.points) {
            const Eigen::Vector3d image = body->plane.reflected(point);
            double off = HUGE_VAL;
            for (std::size_t k = 1; k < right.points.size(); ++k) {
                off = std::min(
                    off, geometry::distanceToSegment(image, right.points[k - 1], right.points[k]));
            }
            EXPECT_LT(off, 1e-6) << name;
        }
        ++pairs;
    }
    EXPECT_GT(pairs, 0);
}

TEST(SmoothLines, WhatIsSymmetricIsCutAlikeToTheLastBits) {
    for (const MeshArrays& mesh :
         {test::wornShirt(), test::wornTrousers(), test::wornSkirt(), mirroredTee()}) {
        expectMirrored(mesh, {});
    }
}

TEST(SmoothLines, BesideAPersonsCutsToo) {
    UserCut opening;
    opening.name = "opening";
    opening.points = {{0, 520, 80}, {0, 0, 80}};
    expectMirrored(mirroredTee(), {opening});
}

}  // namespace
}  // namespace toile
