// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of free edges, and the widths of their allowances.
#include "core/pattern/edge_kinds.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "core/geometry/line.h"
#include "core/pattern/piece_allowance.h"
#include "core/seam/find_seams.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shapes.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

Garment sewn(std::vector<MeshArrays> meshes) {
    Garment garment;
    for (MeshArrays& mesh : meshes) {
        auto piece = std::make_shared<Piece>(
            *test::asPiece(std::move(mesh), "piece " + std::to_string(garment.pieces.size())));
        test::identify(*piece, garment.pieces.size() + 1);
        garment.pieces.push_back(piece);
    }
    garment.seams = findSeams(garment.pieces);
    return garment;
}

/// Of each piece, the kinds of its free edges by name, each with its share of their length.
std::vector<std::map<std::string, double>> kindsOf(const Garment& garment) {
    const auto outlines = seam::buildOutlines(garment.pieces);
    const auto found = findEdgeKinds(garment, outlines);
    std::vector<std::map<std::string, double>> kinds(found.size());
    for (std::size_t p = 0; p < found.size(); ++p) {
        double whole = 0;
        for (std::size_t k = 0; k < found[p].size(); ++k) {
            if (found[p][k].opening >= 0) {
                const int at = static_cast<int>(k);
                const double length = outlines.list[p].arcOf(at + 1) - outlines.list[p].arcOf(at);
                kinds[p][std::string(wordOf(kEdgeKindWords, found[p][k].kind))] += length;
                whole += length;
            }
        }
        for (auto& [kind, length] : kinds[p]) {
            length /= whole;
        }
    }
    return kinds;
}

/// The names of the kinds that a piece has.
std::set<std::string> namesOf(const std::map<std::string, double>& kinds) {
    std::set<std::string> names;
    for (const auto& [name, share] : kinds) {
        names.insert(name);
    }
    return names;
}

/// A wall on the arc of a circle about the y axis, from an angle to another, radians.
MeshArrays wall(double from, double to, double low, double high, double radius = 150,
                int columns = 24, int rows = 20) {
    MeshArrays mesh = test::planeGrid(columns, rows, 1);
    for (auto point : mesh.V.rowwise()) {
        const double at = from + (to - from) * point.x() / columns;
        point = Eigen::RowVector3d(radius * std::sin(at), low + (high - low) * point.y() / rows,
                                   radius * std::cos(at));
    }
    return mesh;
}

constexpr double kHalfTurn = std::numbers::pi;

using Kinds = std::set<std::string>;

class KindsOfSample
    : public testing::TestWithParam<std::pair<const char*, std::map<std::string, Kinds>>> {};

TEST_P(KindsOfSample, AreThoseOfItsPieces) {
    const auto& [file, expected] = GetParam();
    Progress progress;
    const auto garment =
        loadGarment({test::dataFile("samples/" + std::string(file))}, {}, progress);
    ASSERT_TRUE(garment);
    const auto kinds = kindsOf(*garment);
    for (std::size_t p = 0; p < kinds.size(); ++p) {
        const std::string& name = garment->pieces[p]->name;
        const auto known = std::ranges::find_if(
            expected, [&](const auto& of) { return name.starts_with(of.first); });
        EXPECT_EQ(namesOf(kinds[p]), known == expected.end() ? Kinds{} : known->second) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Samples, KindsOfSample,
    testing::Values(
        std::pair("bodice.obj", std::map<std::string, Kinds>{{"front", {"hem", "neckline"}},
                                                             {"side", {"hem", "armhole"}},
                                                             {"back", {"hem", "neckline"}}}),
        std::pair("skirt.obj", std::map<std::string, Kinds>{{"front", {"hem"}},
                                                            {"side", {"hem"}},
                                                            {"back", {"hem"}},
                                                            {"waistband", {"waist"}}}),
        std::pair("trousers.obj",
                  std::map<std::string, Kinds>{
                      {"front", {"hem"}}, {"back", {"hem"}}, {"waistband", {"waist"}}}),
        std::pair("tshirt.obj",
                  std::map<std::string, Kinds>{{"front", {"hem"}},
                                               {"back", {"hem"}},
                                               {"sleeve", {"hem"}},
                                               {"neckband", {"collar-edge"}}}),
        std::pair("cap.obj", std::map<std::string, Kinds>{
                                 {"side", {"hem"}}, {"back", {"hem"}}, {"peak", {"hem"}}})));

TEST(EdgeKinds, OfAFlatOrUnsewnPanelAreUnknown) {
    EXPECT_EQ(namesOf(kindsOf(sewn({test::planeGrid(10, 20, 20)}))[0]), Kinds{"unknown"});
    EXPECT_EQ(namesOf(kindsOf(sewn({wall(-0.8, 0.8, 0, 500)}))[0]), Kinds{"unknown"});
}

TEST(EdgeKinds, OfAnOpenFrontAreTopFrontAndHem) {
    const auto kinds = kindsOf(sewn({wall(0.2, 2 * kHalfTurn - 0.2, 0, 500)}))[0];
    const double around = 150 * (2 * kHalfTurn - 0.4), whole = 2 * around + 2 * 500;
    EXPECT_NEAR(kinds.at("hem"), around / whole, 0.03);
    EXPECT_NEAR(kinds.at("waist"), around / whole, 0.03);
    EXPECT_NEAR(kinds.at("front-edge"), 1000 / whole, 0.03);
}

TEST(EdgeKinds, OfATubeAreHemAndWaistWithASlitWhereASeamIsOpen) {
    MeshArrays front = wall(-kHalfTurn / 2, kHalfTurn / 2, 0, 600);
    for (auto point : front.V.rowwise()) {  // the lower half of its left side hangs open
        const double open = std::clamp(1 - point.y() / 300, 0.0, 1.0);
        point.x() -= point.x() > 0 ? 0.2 * open * point.x() : 0;
    }
    const Garment garment = sewn({front, wall(kHalfTurn / 2, 3 * kHalfTurn / 2, 0, 600)});
    const auto kinds = kindsOf(garment);
    for (const auto& piece : kinds) {
        EXPECT_EQ(namesOf(piece), (Kinds{"hem", "slit", "waist"}));
        EXPECT_NEAR(piece.at("slit"), 300 / (300 + 2 * 150 * kHalfTurn), 0.06);
    }
}

/// A rectangle with a round neck cut into its top: segments from its lower left corner.
PatternPiece withRoundNeck(double width, double height, double radius) {
    std::vector<Eigen::RowVector2d> points{{0, 0}, {width, 0}, {width, height}};
    constexpr int kSteps = 60;
    for (int k = 0; k <= kSteps; ++k) {
        const double at = -kHalfTurn * k / kSteps;
        points.emplace_back(width / 2 + radius * std::cos(at), height + radius * std::sin(at));
    }
    points.emplace_back(0, height);
    PatternPiece piece;
    piece.outline.resize(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        piece.outline.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    const auto line = geometry::Line::closed(piece.outline);
    const auto add = [&](int from, int to, EdgeKind edge, double allowance) {
        PatternSegment& segment = piece.segments.emplace_back();
        segment.from = line.placeOf(from);
        segment.to = line.placeOf(to);
        segment.seam = static_cast<int>(piece.segments.size());
        segment.edge = edge;
        segment.opening = segment.seam;
        segment.allowance = segment.usualAllowance = allowance;
    };
    const int last = static_cast<int>(points.size());
    add(0, 1, EdgeKind::Hem, 30);
    add(1, 2, EdgeKind::Front, 10);
    add(2, 3, EdgeKind::Collar, 10);
    add(3, 3 + kSteps, EdgeKind::Neckline, 7);
    add(3 + kSteps, last - 1, EdgeKind::Collar, 10);
    add(last - 1, last, EdgeKind::Front, 10);
    return piece;
}

TEST(AllowanceLimits, KeepTheEdgeOfANecklineAsLongAsItIs) {
    std::vector<PatternPiece> pieces{withRoundNeck(600, 600, 200)};
    std::vector<PatternPiece> tight{withRoundNeck(400, 600, 120)};
    const PatternSegment before = pieces[0].segments[3];
    limitAllowances(pieces);
    limitAllowances(tight);
    const PatternSegment& neck = pieces[0].segments[3];
    EXPECT_EQ(neck.limit, AllowanceLimit::Curve);
    EXPECT_GE(neck.allowance, 5.5);
    EXPECT_EQ(tight[0].segments[3].allowance, 5);  // less cannot be sewn
    // A round edge of length l that turns by t is t w shorter at the cutting line.
    EXPECT_LE(kHalfTurn * neck.allowance, 0.0301 * (before.to - before.from));
    EXPECT_EQ(pieces[0].segments[0].allowance, 30);
    EXPECT_EQ(pieces[0].segments[1].limit, AllowanceLimit::None);
}

TEST(AllowanceLimits, AreThoseOfTheEdgeOfANecklineThatTurnsMost) {
    // A round back neck and a straight front neck.
    std::vector<PatternPiece> pieces{withRoundNeck(600, 600, 180), withRoundNeck(600, 600, 180)};
    pieces[1].segments[0].edge = EdgeKind::Neckline;
    pieces[1].segments[0].opening = 1;
    pieces[1].segments[0].allowance = 7;
    pieces[1].segments[3].edge = EdgeKind::Collar;
    limitAllowances(pieces);
    const PatternSegment& neck = pieces[0].segments[3];
    EXPECT_LE(kHalfTurn * neck.allowance, 0.0301 * (neck.to - neck.from));
    EXPECT_EQ(pieces[1].segments[0].allowance, neck.allowance);
    EXPECT_EQ(pieces[1].segments[0].limit, AllowanceLimit::Curve);
}

TEST(AllowanceLimits, AreHalfTheWidthOfAStripAndNoneOnAButton) {
    std::vector<PatternPiece> pieces{withRoundNeck(14, 300, 1), withRoundNeck(12, 12, 1)};
    limitAllowances(pieces);
    EXPECT_EQ(pieces[0].segments[1].allowance, 7);  // half of 14
    EXPECT_EQ(pieces[0].segments[1].limit, AllowanceLimit::Width);
    for (const PatternSegment& segment : pieces[1].segments) {
        EXPECT_EQ(segment.allowance, 0);
        EXPECT_EQ(segment.limit, AllowanceLimit::Size);
    }
}

TEST(AllowanceLimits, LeaveAWidthThatTheUserHasSet) {
    std::vector<PatternPiece> pieces{withRoundNeck(14, 300, 1)};
    pieces[0].segments[1].isAllowanceSet = true;
    limitAllowances(pieces);
    EXPECT_EQ(pieces[0].segments[1].allowance, 10);
}

TEST(AllowanceWidths, OfKindsAreUsualUnlessSet) {
    AllowanceWidths widths;
    EXPECT_EQ(widths.widthOf(EdgeKind::Hem), 30);
    EXPECT_EQ(widths.widthOf(EdgeKind::Cuff), 25);
    EXPECT_EQ(widths.widthOf(EdgeKind::Neckline), 7);
    EXPECT_EQ(widths.widthOf(EdgeKind::Waist), widths.seam);
    EXPECT_EQ(widths.widthOf(EdgeKind::Unknown), 30);
    widths.edges[static_cast<std::size_t>(EdgeKind::Cuff)] = 40;
    widths.hem = 12;
    EXPECT_EQ(widths.widthOf(EdgeKind::Cuff), 40);
    EXPECT_EQ(widths.widthOf(EdgeKind::Slit), 12);  // no wider than a hem
}

TEST(EdgeKinds, ThatTheUserSetsDecideTheAllowance) {
    const Garment garment = sewn({test::planeGrid(10, 20, 20)});
    LineSettings lines;
    lines.allowance = AllowanceWidths{};
    Progress progress;
    const PieceResults results = flattenGarment(garment, {}, progress, 0, lines);
    const Pattern found = makePattern(garment, results, lines);
    ASSERT_EQ(found.pieces[0].segments.size(), 4U);
    lines.segments.push_back({.place = found.pieces[0].segments[2].place, .edge = EdgeKind::Front});
    const Pattern set = makePattern(garment, results, lines);
    for (std::size_t k = 0; k < 4; ++k) {
        const PatternSegment& segment = set.pieces[0].segments[k];
        EXPECT_EQ(segment.allowance, k == 2 ? 10 : 30);
        EXPECT_EQ(segment.edge, k == 2 ? EdgeKind::Front : EdgeKind::Unknown);
        EXPECT_EQ(segment.foundEdge, EdgeKind::Unknown);
    }
}

}  // namespace
}  // namespace toile
