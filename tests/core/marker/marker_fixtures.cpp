// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/marker/marker_fixtures.h"

#include <gtest/gtest.h>

namespace toile::test {

PatternPiece clothPiece(const std::string& name, double width, double height, std::uint64_t id) {
    PatternPiece piece;
    piece.name = piece.slug = name;
    piece.id = {id};
    piece.outline.resize(5, 2);
    piece.outline << 0, 0, width, 0, width, height / 2, width / 2, height, 0, height;
    return piece;
}

Pattern clothPattern(std::vector<PatternPiece> pieces) {
    Pattern pattern;
    pattern.name = "shirt";
    pattern.pieces = std::move(pieces);
    return pattern;
}

ClothMarker laidOn(double width, const Pattern& pattern, const MarkerSettings& settings,
                   const std::vector<KeptCopy>& kept, int rounds, const std::string& material) {
    Fabric fabric = fabricPresets().front();
    fabric.width = width;
    auto nester = MarkerNester::make(std::make_shared<const Pattern>(pattern), material, fabric,
                                     settings, kept, Progress());
    if (!nester) {
        ADD_FAILURE() << sentence(nester.error());
        return {};
    }
    for (int k = 0; k < rounds; ++k) {
        nester->step(Progress());
    }
    EXPECT_TRUE(misplacedCopies(pattern, nester->best(), settings).empty());
    return nester->best();
}

}  // namespace toile::test
