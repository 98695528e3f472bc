// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <gtest/gtest.h>

#include "core/prove/fresh_cloth.h"
#include "core/sew/gap.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/shared_data.h"

namespace toile::prove {
namespace {

/// What a twentieth of the cloth is strained by where the design has it.
double strainAtFirst(const std::filesystem::path& file, const LineSettings& lines) {
    Progress progress;
    const auto garment = loadGarment({file}, {}, progress);
    EXPECT_TRUE(garment);
    const PieceResults results = flattenGarment(*garment, {}, progress, 0, lines);
    const LaidOutPattern laid = inRows(*garment, results, lines);
    const auto fresh =
        freshCloth(ExportSource(*garment, results, laid, {}, {}, lines), {}, progress);
    EXPECT_TRUE(fresh);
    return sew::strainOf(fresh->cloth, fresh->cloth.X).most95;
}

// Lines that are images of others begin elsewhere than their outlines do.
TEST(DrawnCloth, OfFairAndMirroredLinesLiesAsTheExactDoes) {
    for (const char* sample :
         {"samples/tshirt.obj", "samples/trousers.obj", "garments/tee_sim.obj"}) {
        SCOPED_TRACE(sample);
        const auto file = test::dataFile(sample);
        TOILE_NEEDS_SHARED(file);
        LineSettings lines;
        const double exact = strainAtFirst(file, lines);
        lines.fairing = Fairing{};
        EXPECT_LT(strainAtFirst(file, lines), exact + 0.02);
        lines.mirror = Mirror::Mean;
        EXPECT_LT(strainAtFirst(file, lines), exact + 0.02);
    }
}

}  // namespace
}  // namespace toile::prove
