// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <gtest/gtest.h>

#include "core/garment/lineage.h"
#include "core/project/piece_settings.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

/// "front" and "back", each a square of two triangles.
Garment twoSquares() {
    const test::TemporaryFolder folder;
    const auto file = folder.write("two.obj",
                                   "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nv 200 0 0\n"
                                   "v 300 0 0\nv 300 100 0\nv 200 100 0\no front\nf 1 2 3\n"
                                   "f 1 3 4\no back\nf 5 6 7\nf 5 7 8\n");
    LoadOptions options;
    options.unit = LengthUnit::Millimetre;
    Progress progress;
    return loadGarment({file}, options, progress).value();
}

LoadOptions cutAcrossFront(const std::vector<double>& heights) {
    LoadOptions options;
    options.unit = LengthUnit::Millimetre;
    for (const double y : heights) {
        options.seams.cuts.push_back(
            {"at " + std::to_string(y), UserCut::Kind::Path, {{0, y, 0}, {100, y, 0}}, false});
    }
    giveIds(options.seams.cuts);
    return options;
}

TEST(PieceColours, PartsOfAPieceAreShadesOfItAndTheOthersStay) {
    const Garment whole = twoSquares();
    const PieceLabels before = withColours({}, nullptr, whole);
    const std::vector<int> old = coloursOf(before, whole);
    Progress progress;
    const Garment parts = *cutGarment(whole, cutAcrossFront({20, 50, 80}), progress);
    ASSERT_EQ(parts.pieces.size(), 5U);
    PieceLabels labels = withColours(before, &whole, parts);
    const std::vector<int> colours = coloursOf(labels, parts);
    EXPECT_EQ(std::set<int>(colours.begin(), colours.end()).size(), colours.size());
    const std::vector<int> was = predecessors(whole.pieces, parts.pieces);
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const int parent = old[static_cast<std::size_t>(was[i])];
        EXPECT_EQ(colours[i] % kHueCount, parent % kHueCount) << parts.pieces[i]->name;
        if (parts.pieces[i]->name == "back") {
            EXPECT_EQ(colours[i], parent);
        }
    }
    labels = withColours(std::move(labels), &parts, whole);
    EXPECT_EQ(coloursOf(labels, whole), old);
}

TEST(PieceColours, AShadeIsNotThatOfAnotherPiece) {
    const Garment whole = twoSquares();
    PieceLabels labels = withColours({}, nullptr, whole);
    labels[whole.pieces[1]->id].colour = kHueCount;  // the first shade of the front
    Progress progress;
    const Garment parts = *cutGarment(whole, cutAcrossFront({50}), progress);
    const std::vector<int> colours =
        coloursOf(withColours(std::move(labels), &whole, parts), parts);
    EXPECT_EQ(std::set<int>(colours.begin(), colours.end()).size(), colours.size());
}

}  // namespace
}  // namespace toile
