// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/drawing/key_points.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/segment.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/formats/exported_garments.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// What every stretch is to be kept to, mm.
constexpr double kStretchLength = 0.05, kBeside = 0.1;

std::vector<KeyPoints> keysOf(const test::ExportedGarment& made) {
    const ExportSource source = made.source();
    return keyPoints(source.drawing(), made.laid.pattern, made.garment);
}

double distanceFromChord(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                         const Eigen::Vector2d& b) {
    return (a + geometry::nearestShare(p, a, b) * (b - a) - p).norm();
}

/// Between turn points that follow each other the polygon is as long as the line, and nowhere far
/// from it.
void expectKept(const DrawnPath& path, const KeyPoints& keys) {
    const geometry::Line line(path.points, path.closed);
    ASSERT_GE(keys.size(), 2U) << path.id;
    double lost = 0;
    const std::size_t count = path.closed ? keys.size() : keys.size() - 1;
    for (std::size_t k = 0; k < count; ++k) {
        const double from = keys[k].at, next = keys[(k + 1) % keys.size()].at;
        const double to = next > from ? next : next + line.length();
        const Eigen::Vector2d a = line.pointAt(from), b = line.pointAt(to);
        lost = keys[k].isTurn ? 0 : lost;
        lost += to - from - (b - a).norm();
        EXPECT_LT(lost, kStretchLength) << path.id << ' ' << from;
        for (int v = line.firstAfter(from); v < line.firstAfter(to); ++v) {
            EXPECT_LT(distanceFromChord(line.point(v).transpose(), a, b), kBeside) << path.id;
        }
    }
    EXPECT_TRUE(std::ranges::all_of(
        keys, [&](const KeyPoint& key) { return key.at >= 0 && key.at <= line.length(); }));
}

std::set<double> sharesOf(const DrawnEdge& edge, const DrawnPath& path, const KeyPoints& keys,
                          bool reversed) {
    const geometry::Line line(path.points, path.closed);
    std::set<double> shares;
    for (const KeyPoint& key : keys) {
        for (const double turns : {0.0, line.length()}) {
            const double share = (key.at + turns - edge.from) / (edge.to - edge.from);
            if (share > -1e-9 && share < 1 + 1e-9) {
                shares.insert(reversed ? 1 - share : share);
            }
        }
    }
    return shares;
}

void expectSharedStations(const test::ExportedGarment& made) {
    const ExportSource source = made.source();
    const Drawing& drawing = source.drawing();
    const std::vector<KeyPoints> keys = keysOf(made);
    int seams = 0;
    for (const DrawnEdge& edge : drawing.edges) {
        const auto other = std::ranges::find(drawing.edges, edge.pair, &DrawnEdge::id);
        if (edge.pair.empty() || other == drawing.edges.end() || edge.id > other->id) {
            continue;
        }
        const auto here = static_cast<std::size_t>(edge.path),
                   there = static_cast<std::size_t>(other->path);
        const auto own = sharesOf(edge, drawing.paths[here], keys[here], false);
        const Seam& seam = made.garment.seams.seams[static_cast<std::size_t>(edge.number) - 1];
        const auto its = sharesOf(*other, drawing.paths[there], keys[there],
                                  seam.left.reversed != seam.right.reversed);
        ASSERT_EQ(own.size(), its.size()) << edge.seam;
        for (auto a = own.begin(), b = its.begin(); a != own.end(); ++a, ++b) {
            EXPECT_NEAR(*a, *b, 1e-9) << edge.seam;
        }
        ++seams;
    }
    EXPECT_GT(seams, 0);
}

struct KeyCase {
    const char* file;
    bool isPattern;
};

class KeyPointsOfGarments : public testing::TestWithParam<KeyCase> {};

TEST_P(KeyPointsOfGarments, KeepEveryLineAndAreSharedBySeams) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam().file));
    const test::ExportedGarment made = test::exported(GetParam().file, GetParam().isPattern);
    const ExportSource source = made.source();
    const std::vector<KeyPoints> keys = keysOf(made);
    ASSERT_EQ(keys.size(), source.drawing().paths.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const DrawnPath& path = source.drawing().paths[k];
        if (path.layer == LayerKind::Cut || path.layer == LayerKind::Sew ||
            path.layer == LayerKind::Internal) {
            expectKept(path, keys[k]);
        } else {
            EXPECT_TRUE(keys[k].empty()) << path.id;
        }
    }
    expectSharedStations(made);
}

TEST_P(KeyPointsOfGarments, HaveAllEndsOfSegmentsAndBeginAtATurn) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam().file));
    const test::ExportedGarment made = test::exported(GetParam().file, GetParam().isPattern);
    const std::vector<KeyPoints> keys = keysOf(made);
    const ExportSource source = made.source();
    for (const DrawnBlock& block : source.drawing().blocks) {
        const PatternPiece& piece = made.laid.pattern.pieces[static_cast<std::size_t>(block.piece)];
        const KeyPoints& own = keys[block.path + (piece.cuttingLine.rows() > 0 ? 1 : 0)];
        EXPECT_TRUE(own.front().isTurn) << piece.name;
        for (const PatternSegment& segment : piece.segments) {
            EXPECT_TRUE(std::ranges::any_of(own,
                                            [&](const KeyPoint& key) {
                                                return key.isTurn &&
                                                       std::abs(key.at - segment.from) < 2e-3;
                                            }))
                << piece.name << ' ' << segment.from;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Garments, KeyPointsOfGarments,
                         testing::Values(KeyCase{"samples/tshirt.obj", true},
                                         KeyCase{"samples/tshirt.obj", false},
                                         KeyCase{"samples/bodice.obj", true},
                                         KeyCase{"garments/skirt_clo.obj", true}),
                         [](const auto& tested) {
                             std::string name = tested.param.file;
                             std::ranges::replace_if(
                                 name, [](char c) { return c == '/' || c == '.'; }, '_');
                             return name + (tested.param.isPattern ? "_pattern" : "_exact");
                         });

TEST(KeyPoints, OfStraightLinesAreTheirEnds) {
    Pattern pattern{"straight", {}};
    pattern.pieces.push_back({{}, "band", "band", test::rectangle(0, 0, 420, 22)});
    pattern.pieces.push_back({{}, "u", "u", test::horseshoe(0, 0, 300, 60)});
    Points2 many(40, 2);  // the band with nine points more on each of its edges
    for (int k = 0; k < 40; ++k) {
        const Points2 corners = test::rectangle(0, 0, 100, 50);
        many.row(k) = corners.row(k / 10) +
                      (k % 10) / 10.0 * (corners.row((k / 10 + 1) % 4) - corners.row(k / 10));
    }
    pattern.pieces.push_back({{}, "fine", "fine", many});
    const test::ExportedGarment made = test::exported(pattern);
    const ExportSource source = made.source();
    const std::vector<KeyPoints> keys = keysOf(made);
    const std::size_t corners[] = {4, 8, 4};
    for (std::size_t b = 0; b < 3; ++b) {
        const KeyPoints& own = keys[source.drawing().blocks[b].path];
        EXPECT_EQ(own.size(), corners[b]);
        EXPECT_TRUE(std::ranges::all_of(own, &KeyPoint::isTurn));
    }
}

TEST(KeyPoints, OfLinesWithoutSeamsKeepThemToo) {
    for (const test::ExportedGarment& made :
         {test::exported(test::sewingPattern()), test::markedPieces()}) {
        const ExportSource source = made.source();
        const std::vector<KeyPoints> keys = keysOf(made);
        for (std::size_t k = 0; k < keys.size(); ++k) {
            if (!keys[k].empty()) {
                expectKept(source.drawing().paths[k], keys[k]);
            }
        }
    }
}

/// A circle of radius r loses pi^3 r / 3 n^2 to its polygon of n points.
TEST(KeyPoints, AreNotManyMoreThanTheLengthNeeds) {
    constexpr int kPoints = 2000;
    constexpr double kRadius = 150;
    Points2 circle(kPoints, 2);
    for (int k = 0; k < kPoints; ++k) {
        const double angle = 2 * kPi * k / kPoints;
        circle.row(k) << kRadius * std::cos(angle), kRadius * std::sin(angle);
    }
    const geometry::Line line(circle, true);
    const KeyStretch all{&line, 0, line.length()};
    const double needed = std::sqrt(std::pow(kPi, 3) * kRadius / (3 * kKeyLost));
    const std::vector<double> shares = keyShares({&all, 1}, {});
    EXPECT_GT(static_cast<double>(shares.size()), needed);
    EXPECT_LT(static_cast<double>(shares.size()), 1.5 * needed);
    EXPECT_EQ(shares.front(), 0);
    EXPECT_EQ(shares.back(), 1);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
}

TEST(KeyPoints, KeepWhatIsFixedAndBothSides) {
    const Points2 straight = (Points2(2, 2) << 0, 0, 500, 0).finished();
    const Points2 zigzag = (Points2(5, 2) << 0, 0, 100, 30, 200, 0, 300, 30, 400, 0).finished();
    const geometry::Line a(straight, false), b(zigzag, false);
    const KeyStretch sides[] = {{&a, 0, a.length()}, {&b, 0, b.length(), true}};
    const std::vector<double> shares = keyShares(sides, {0.1, 2.0, std::nan("")});
    const std::vector<double> expected{0, 0.1, 0.25, 0.5, 0.75, 1};
    ASSERT_EQ(shares.size(), expected.size());
    for (std::size_t k = 0; k < shares.size(); ++k) {
        EXPECT_NEAR(shares[k], expected[k], 1e-12);
    }
}

/// The line that a mirrored piece is drawn by runs the other way round.
TEST(KeyPoints, OfMirroredPiecesAreTheImages) {
    test::ExportedGarment made = test::exported("samples/tshirt.obj", true);
    const std::vector<KeyPoints> before = keysOf(made);
    const ExportSource plain = made.source();
    std::vector<std::size_t> counts;
    for (const DrawnBlock& block : plain.drawing().blocks) {
        counts.push_back(before[block.path + 1].size());
    }
    for (PlacedCopy& copy : made.laid.marker.copies) {
        copy.placement.mirrored = true;
    }
    const ExportSource mirrored = made.source();
    const std::vector<KeyPoints> after = keysOf(made);
    for (std::size_t b = 0; b < counts.size(); ++b) {
        const std::size_t path = mirrored.drawing().blocks[b].path + 1;
        expectKept(mirrored.drawing().paths[path], after[path]);
        EXPECT_NEAR(static_cast<double>(after[path].size()), static_cast<double>(counts[b]),
                    0.1 * static_cast<double>(counts[b]));
    }
    expectSharedStations(made);
}

}  // namespace
}  // namespace toile
