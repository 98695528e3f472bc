// SPDX-License-Identifier: GPL-3.0-or-later
// Whether cuts are proposed where tailors cut: garments of known panels as one skin, without a UV
// map; the tables in docs/tailor.md.
#include <algorithm>
#include <cstdlib>
#include <utility>

#include <gtest/gtest.h>

#include "core/assemble/cut_pieces.h"
#include "core/base/text.h"
#include "core/geometry/segment.h"
#include "core/tailor/tailor_cuts.h"
#include "core/toile/pipeline.h"
#include "tests/cli/docs_table.h"
#include "tests/cli/erased_traces.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

/// Nearer than this, mm, a proposal meets a seam.
constexpr double kMeets = 25;

using SewnLine = std::pair<Eigen::Vector3d, Eigen::Vector3d>;

/// Of the length of some lines, the part near others.
double partNear(const std::vector<SewnLine>& lines, const std::vector<SewnLine>& others) {
    double near = 0, whole = 0;
    for (const auto& [a, b] : lines) {
        const double length = (b - a).norm();
        const int samples = std::max(1, static_cast<int>(length / 5));
        for (int k = 0; k < samples; ++k) {
            const Eigen::Vector3d here = a + (k + 0.5) / samples * (b - a);
            const bool meets = std::ranges::any_of(others, [&here](const SewnLine& other) {
                return geometry::distanceToSegment(here, other.first, other.second) < kMeets;
            });
            near += meets ? length / samples : 0;
            whole += length / samples;
        }
    }
    return whole > 0 ? near / whole : 0;
}

Garment loadedBy(const std::string& file, SplitMode split, bool weld) {
    Progress progress;
    auto garment = loadGarment({test::sharedFile("garments/" + file)},
                               {.split = split, .weld = weld}, progress);
    EXPECT_TRUE(garment) << file;
    return garment ? *garment : Garment{};
}

/// The lines along which a garment is sewn.
std::vector<SewnLine> sewnLines(const Garment& garment) {
    std::vector<SewnLine> lines;
    for (const Seam& seam : garment.seams.seams) {
        if (seam.right.piece < 0) {
            continue;
        }
        const Piece& piece = *garment.pieces[seam.left.piece];
        const std::vector<int>& loop =
            seam.left.loop == 0 ? piece.boundary : piece.holes[seam.left.loop - 1];
        const auto at = [&](int k) -> Eigen::Vector3d {
            return piece.mesh.V.row(loop[static_cast<std::size_t>(k) % loop.size()]);
        };
        for (int k = seam.left.first; k < seam.left.first + seam.left.count; ++k) {
            lines.emplace_back(at(k), at(k + 1));
        }
    }
    return lines;
}

struct Truth {
    const char* file;
    int pieces;                    ///< that it was sewn of
    double asSewn, withoutTraces;  ///< recall at least; as sewn precision, too
    bool hasSleeves;
    bool isCounted;  ///< whether the number of pieces is to be met
};

constexpr Truth kTruths[] = {{"tee_sim.obj", 6, 0.8, 0.7, true, true},
                             {"tshirt.obj", 4, 0.8, 0.7, true, true},
                             {"longsleeve.obj", 6, 0.8, 0.5, true, true},
                             {"polo.obj", 7, 0.7, 0.5, true, false},
                             {"dress.obj", 13, 0.7, 0.45, false, false}};

struct Found {
    double recall, precision;
    std::size_t pieces;
    bool areSleevesApart;
};

Found cutAndCompare(const std::shared_ptr<const Piece>& skin, const std::vector<SewnLine>& truth) {
    bool hasArmholes = false;
    const CutPieces made = cutPieces({skin}, {}, true, Progress(), {},
                                     {[&](const auto& piece, const auto&, const auto& progress) {
                                         ProposedCuts proposed;
                                         for (const TailorCut& cut : tailorCuts(piece, progress)) {
                                             proposed.cuts.push_back({cut.cut, {}});
                                             hasArmholes =
                                                 hasArmholes || cut.line == TailorLine::Armhole;
                                         }
                                         return proposed;
                                     }});
    std::vector<SewnLine> lines;
    for (const AppliedCut& cut : made.cuts) {
        for (std::size_t k = 1; k < cut.points.size(); ++k) {
            lines.emplace_back(cut.points[k - 1], cut.points[k]);
        }
    }
    return {partNear(truth, lines), partNear(lines, truth), made.pieces.size(),
            hasArmholes && made.pieces.size() >= 4};
}

/// The same by the form alone: the mean of three ways to erase the traces.
Found cutWithoutTraces(const Piece& skin, const std::vector<SewnLine>& truth) {
    constexpr unsigned kSeeds[] = {7, 8, 9};
    Found mean{0, 0, 0, false};
    for (const unsigned seed : kSeeds) {
        const auto erased = std::make_shared<Piece>(skin);
        erased->mesh = test::withoutTraces(erased->mesh, seed);
        erased->table = buildEdgeTable(erased->mesh.F, static_cast<int>(erased->mesh.V.rows()));
        const Found found = cutAndCompare(erased, truth);
        mean.recall += found.recall / std::size(kSeeds);
        mean.precision += found.precision / std::size(kSeeds);
        mean.pieces = std::max(mean.pieces, found.pieces);
    }
    return mean;
}

std::string cells(const Found& found) {
    return fixed(found.recall, 2) + " | " + fixed(found.precision, 2) + " | " +
           std::to_string(found.pieces);
}

TEST(TailorTruthSlow, ProposedCutsMeetTheSeamsThatAGarmentWasSewnBy) {
    TOILE_NEEDS_SHARED(test::sharedFile("garments"));
    std::string table =
        "| Garment | Panels | As sewn: recall | precision | pieces | Traces erased: recall | "
        "precision | pieces |\n|---|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const Truth& truth : kTruths) {
        SCOPED_TRACE(truth.file);
        const std::vector<SewnLine> seams = sewnLines(loadedBy(truth.file, SplitMode::Uv, false));
        const Garment skins = loadedBy(truth.file, SplitMode::Components, true);
        ASSERT_EQ(skins.pieces.size(), 1U);
        const Found found = cutAndCompare(skins.pieces[0], seams);
        EXPECT_GE(found.recall, truth.asSewn);
        EXPECT_GE(found.precision, truth.asSewn);
        EXPECT_EQ(found.areSleevesApart, truth.hasSleeves);
        if (truth.isCounted) {
            EXPECT_LE(std::abs(static_cast<int>(found.pieces) - truth.pieces), 2);
        }
        const Found byForm = cutWithoutTraces(*skins.pieces[0], seams);
        EXPECT_GE(byForm.recall, truth.withoutTraces);
        table += "| " + std::string(truth.file) + " | " + std::to_string(truth.pieces) + " | " +
                 cells(found) + " | " + cells(byForm) + " |\n";
    }
    test::updateTableInDocs("tailor.md", "seams of known garments", table);
}

}  // namespace
}  // namespace toile
