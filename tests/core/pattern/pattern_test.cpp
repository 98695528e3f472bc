// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/pattern.h"

#include <set>

#include <gtest/gtest.h>

#include "core/flatten/base/piece_result.h"
#include "core/pattern/piece_marks.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

struct Made {
    Garment garment;
    PieceResults results;
    Pattern pattern;
};

Made made(const char* sample) {
    Progress progress;
    Made made{loadGarment({test::dataFile(sample)}, {}, progress).value(), {}, {}};
    made.results = flattenGarment(made.garment, {}, progress);
    made.pattern = makePattern(made.garment, made.results);
    return made;
}

double lengthOf(const Points2& line, bool closed) {
    double length = closed ? (line.row(0) - line.row(line.rows() - 1)).norm() : 0;
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
        length += (line.row(i) - line.row(i - 1)).norm();
    }
    return length;
}

TEST(Pattern, SeamsAndFreeEdgesCoverTheOutline) {
    for (const char* sample : {"samples/tshirt.obj", "samples/trousers.obj"}) {
        const Made all = made(sample);
        ASSERT_EQ(all.pattern.pieces.size(), all.garment.pieces.size());
        for (const PatternPiece& piece : all.pattern.pieces) {
            double covered = 0;
            for (const SeamLine& seam : piece.seams) {
                covered += lengthOf(seam.line, false);
                EXPECT_TRUE(seam.seam);
            }
            EXPECT_NEAR(covered / lengthOf(piece.outline, true), 1, 1e-9) << piece.name;
        }
    }
}

TEST(Pattern, BothSidesOfASeamAreThereOnceAndOfOneLength) {
    const Made all = made("samples/tshirt.obj");
    std::map<SeamId, std::vector<const SeamLine*>> sides;
    for (const PatternPiece& piece : all.pattern.pieces) {
        for (const SeamLine& seam : piece.seams) {
            sides[seam.seam].push_back(&seam);
        }
    }
    EXPECT_EQ(sides.size(), all.garment.seams.seams.size());
    for (const Seam& seam : all.garment.seams.seams) {
        const auto& found = sides.at(seam.id);
        ASSERT_EQ(found.size(), seam.kind == SeamKind::Free ? 1U : 2U) << seam.name;
        if (found.size() == 2) {
            EXPECT_NE(found[0]->isRight, found[1]->isRight);
            EXPECT_EQ(found[0]->number, found[1]->number);
            EXPECT_NEAR(lengthOf(found[0]->line, false) / lengthOf(found[1]->line, false),
                        seam.length3d[0] / seam.length3d[1], 1e-9);
        }
    }
}

TEST(Pattern, IsMadeOnceHoweverItsCopiesLie) {
    const Made all = made("samples/tshirt.obj");
    const PatternPiece& piece = all.pattern.pieces[0];
    const std::vector<std::string> lines = labelLines(piece.name, piece, false, {});
    const Placement here{{0, 0}, 0.4}, there{{1234.5, -987.25}, 0.4};
    const PieceMarks one = placeMarks(piece, here, lines, 0.3),
                     other = placeMarks(piece, there, lines, 0.3);
    // Marks go along, to the bit.
    EXPECT_EQ(one.label.position, other.label.position);
    ASSERT_TRUE(one.grain && other.grain);
    EXPECT_EQ(one.grain->from, other.grain->from);
    const Eigen::Vector2d way = (one.grain->to - one.grain->from).normalized();
    EXPECT_NEAR(std::atan2(way.y(), way.x()), 0.7, 1e-9);
    const auto seams = seamMarks(piece, here), moved = seamMarks(piece, there);
    ASSERT_EQ(seams.size(), moved.size());
    for (std::size_t i = 0; i < seams.size(); ++i) {
        ASSERT_TRUE(seams[i].numberPlace && moved[i].numberPlace);
        EXPECT_EQ(seams[i].numberPlace->position, moved[i].numberPlace->position);
    }
}

TEST(Pattern, SlugsAreUniqueAmongWhatIsFlat) {
    Made all = made("samples/tshirt.obj");
    std::set<std::string> slugs;
    for (const PatternPiece& piece : all.pattern.pieces) {
        EXPECT_TRUE(slugs.insert(piece.slug).second);
    }
    all.results[0] = nullptr;
    const Pattern without = makePattern(all.garment, all.results);
    EXPECT_EQ(without.pieces[0].outline.rows(), 0);
    EXPECT_TRUE(without.pieces[0].slug.empty());
    EXPECT_EQ(without.pieces[0].number, 0);
    EXPECT_EQ(without.pieces[1].number, 1);
    EXPECT_EQ(drawnCount(without), drawnCount(all.pattern) - 1);
    EXPECT_EQ(all.pattern.pieces.back().number, drawnCount(all.pattern));
    EXPECT_EQ(without.pieces[1].outline, all.pattern.pieces[1].outline);
}

}  // namespace
}  // namespace toile
