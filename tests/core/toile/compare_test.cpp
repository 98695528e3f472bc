// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/seam/seam_measure.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

Garment loadFile(const std::filesystem::path& path) {
    Progress progress;
    auto garment = loadGarment({path}, {LengthUnit::Millimetre}, progress);
    EXPECT_TRUE(garment) << (garment ? "" : sentence(garment.error()));
    return garment ? *garment : Garment{};
}

TEST(CompareMethods, GivesWhatFlatteningGives) {
    const Garment garment = loadFile(test::dataFile("samples/tshirt.obj"));
    Progress progress;
    const Method methods[] = {Method::Natural, Method::Wang2005};
    const Comparison comparison = compareMethods(garment, methods, {}, progress);
    EXPECT_NEAR(progress.fraction(), 1, 1e-9);
    ASSERT_EQ(comparison.methods.size(), 2U);
    for (std::size_t m = 0; m < 2; ++m) {
        const ComparedMethod& method = comparison.methods[m];
        EXPECT_EQ(method.method, methods[m]);
        FlattenOptions options;
        options.method = methods[m];
        const PieceResults alone = flattenGarment(garment, options, progress);
        double piE = 0, dirichlet = 0, area = 0, error = 0;
        for (std::size_t k = 0; k < alone.size(); ++k) {
            const PieceQuality& q = *alone[k]->quality;
            EXPECT_EQ(method.results[k]->flat->Q, alone[k]->flat->Q);
            EXPECT_EQ(method.pieceFigures[k][Criterion::PiE], q.piE);
            piE += q.piE / static_cast<double>(alone.size());
            dirichlet += q.area3d * *q.symmetricDirichlet;
            area += q.area3d;
            error = std::max(error, q.maxBoundaryLengthError);
        }
        EXPECT_EQ(method.figures.pieces, 5);
        EXPECT_EQ(method.figures.failed, 0);
        EXPECT_GT(*method.figures[Criterion::Seconds], 0);
        EXPECT_NEAR(*method.figures[Criterion::PiE], piE, 1e-12);
        EXPECT_NEAR(*method.figures[Criterion::SymmetricDirichlet], dirichlet / area, 1e-12);
        EXPECT_EQ(*method.figures[Criterion::LengthError], error);
        EXPECT_FALSE(method.figures[Criterion::ReferenceRms]);  // our own samples have no designer
    }
    EXPECT_LE(*comparison.methods[1].figures[Criterion::SeamMismatch], 1e-6);
    EXPECT_GT(*comparison.methods[0].figures[Criterion::SeamMismatch], 0.5);
}

TEST(CompareMethods, ASeamsMismatchStandsAtBothItsPieces) {
    const Garment garment = loadFile(test::dataFile("samples/tshirt.obj"));
    Progress progress;
    const Method methods[] = {Method::Natural};
    const Comparison comparison = compareMethods(garment, methods, {}, progress);
    const ComparedMethod& method = comparison.methods.front();
    double largest = 0;
    for (const ComparedFigures& piece : method.pieceFigures) {
        largest = std::max(largest, *piece[Criterion::SeamMismatch]);
    }
    EXPECT_EQ(largest, *method.figures[Criterion::SeamMismatch]);
    std::set<int> worst;
    for (std::size_t k = 0; k < method.pieceFigures.size(); ++k) {
        if (*method.pieceFigures[k][Criterion::SeamMismatch] == largest) {
            worst.insert(static_cast<int>(k));
        }
    }
    const auto& seams = garment.seams.seams;
    EXPECT_TRUE(std::any_of(seams.begin(), seams.end(), [&](const Seam& seam) {
        return worst == std::set<int>{seam.left.piece, seam.right.piece};
    }));
}

TEST(ComparedPiece, IsAsInTheWholeGarmentAndTakesThePiecesSewnToItAlone) {
    const Garment garment = loadFile(test::dataFile("samples/tshirt.obj"));
    Progress progress;
    const Method methods[] = {Method::Lscm};
    const ComparedMethod whole = compareMethods(garment, methods, {}, progress).methods.front();
    for (int piece = 0; piece < static_cast<int>(garment.pieces.size()); ++piece) {
        const auto at = static_cast<std::size_t>(piece);
        const std::vector<int> others = sewnTo(garment, piece);
        EXPECT_FALSE(others.empty());
        PieceResults some(garment.pieces.size());
        some[at] = whole.results[at];
        for (const int other : others) {
            EXPECT_NE(other, piece);
            const std::vector<int> back = sewnTo(garment, other);
            EXPECT_TRUE(std::ranges::find(back, piece) != back.end());
            some[static_cast<std::size_t>(other)] = whole.results[static_cast<std::size_t>(other)];
        }
        const ComparedFigures figures = comparedPiece(garment, some, piece);
        EXPECT_EQ(figures[Criterion::SeamMismatch],
                  whole.pieceFigures[at][Criterion::SeamMismatch]);
        EXPECT_EQ(figures[Criterion::PiA], whole.pieceFigures[at][Criterion::PiA]);
        EXPECT_EQ(figures[Criterion::Seconds], whole.pieceFigures[at][Criterion::Seconds]);

        PieceResults alone(garment.pieces.size());
        alone[at] = whole.results[at];
        EXPECT_EQ(comparedPiece(garment, alone, piece)[Criterion::PiE],
                  whole.pieceFigures[at][Criterion::PiE]);
    }
}

TEST(CompareMethods, AFailedPieceIsCountedAndTheOthersAreCompared) {
    const test::TemporaryFolder folder;
    const Garment garment =
        loadFile(folder.write("mixed.obj",
                              "v 0 0 0\nv 300 0 0\nv 0 400 0\no flap\nf 1 2 3\n"
                              "v 0 0 500\nv 100 0 500\nv 0 100 500\nv 0 0 600\n"
                              "o ball\nf -4 -3 -2\nf -4 -1 -3\nf -3 -1 -2\nf -4 -2 -1\n"));
    Progress progress;
    const Method methods[] = {Method::Wang2005};
    const ComparedFigures figures =
        compareMethods(garment, methods, {}, progress).methods.front().figures;
    EXPECT_EQ(figures.pieces, 2);
    EXPECT_EQ(figures.failed, 1);
    EXPECT_NEAR(*figures[Criterion::SymmetricDirichlet], 1, 1e-12);
    EXPECT_FALSE(figures[Criterion::SeamMismatch]);
}

TEST(CompareMethods, ACancelLeavesNothingFlat) {
    const Garment garment = loadFile(test::dataFile("samples/cap.obj"));
    Progress progress;
    progress.cancel();
    const Method methods[] = {Method::Wang2005, Method::Natural};
    const auto compared = compareMethods(garment, methods, {}, progress).methods;
    EXPECT_EQ(compared.size(), 2U);
    for (const ComparedMethod& method : compared) {
        EXPECT_EQ(method.figures.pieces, 7);
        EXPECT_EQ(method.figures.failed, 7);
        EXPECT_FALSE(method.figures[Criterion::PiE] || method.figures[Criterion::LengthError]);
    }
}

TEST(Criteria, AreListedInTheirOrder) {
    ASSERT_EQ(allCriteria().size(), kCriterionCount);
    for (std::size_t k = 0; k < kCriterionCount; ++k) {
        EXPECT_EQ(static_cast<std::size_t>(allCriteria()[k].criterion), k);
        EXPECT_EQ(&traits(allCriteria()[k].criterion), &allCriteria()[k]);
    }
}

TEST(BestOf, IsTheLeastAndTheFirstOfEquals) {
    using Values = std::vector<std::optional<double>>;
    EXPECT_EQ(bestOf(Criterion::PiA, Values{3, {}, 1, 1}), 2U);
    EXPECT_FALSE(bestOf(Criterion::PiA, Values{{}, {}}));
    EXPECT_FALSE(bestOf(Criterion::PiA, {}));
    // Who does not stretch at all is no better for being looser, nor the other way round.
    EXPECT_EQ(bestOf(Criterion::StrainMax, Values{0.1, -0.1, -0.2}), 1U);
    EXPECT_EQ(bestOf(Criterion::StrainMin, Values{-0.1, 0.2, 0.1}), 1U);
}

/// Flat, with their panels, are all of six pieces but these.
ComparedMethod withRms(Method method, std::optional<double> rms, const std::set<int>& without) {
    ComparedMethod made{method, {}, {}, std::vector<ComparedFigures>(6)};
    made.figures.pieces = 6;
    made.figures[Criterion::ReferenceRms] = rms;
    for (int k = 0; k < 6; ++k) {
        const int count = without.contains(k) ? 0 : 1;
        made.pieceFigures[static_cast<std::size_t>(k)].referencedPieces = count;
        made.figures.referencedPieces += count;
    }
    return made;
}

TEST(NearerThanLengthKeeping, NamesTheFreeOutlinesThatAreNearer) {
    const Comparison comparison{{withRms(Method::Natural, 2.2, {}),
                                 withRms(Method::Curvature, 3, {}), withRms(Method::Lscm, 2.1, {}),
                                 withRms(Method::Abf, 2.5, {}),
                                 withRms(Method::Wang2005, 2.4, {})}};
    const auto nearer = nearerThanLengthKeeping(comparison);
    ASSERT_TRUE(nearer);
    EXPECT_EQ(nearer->freeOutline, (std::vector<std::size_t>{2, 0}));
    EXPECT_EQ(nearer->lengthKeeping, 4U);
}

TEST(NearerThanLengthKeeping, ComparesMeansOverTheSamePanelsOnly) {
    const Comparison easier{{withRms(Method::Natural, 1, {4}), withRms(Method::Wang2005, 2, {})}};
    EXPECT_FALSE(nearerThanLengthKeeping(easier));
    const Comparison asMany{{withRms(Method::Natural, 1, {4}), withRms(Method::Wang2005, 2, {2})}};
    EXPECT_FALSE(nearerThanLengthKeeping(asMany));
    const Comparison same{{withRms(Method::Natural, 1, {4}), withRms(Method::Wang2005, 2, {4}),
                           withRms(Method::Abf, 0.5, {4, 5})}};
    const auto nearer = nearerThanLengthKeeping(same);
    ASSERT_TRUE(nearer);
    EXPECT_EQ(nearer->freeOutline, std::vector<std::size_t>{0});
    const Comparison farther{{withRms(Method::Natural, 3, {}), withRms(Method::Wang2005, 2, {})}};
    EXPECT_FALSE(nearerThanLengthKeeping(farther));
    const std::set<int> all{0, 1, 2, 3, 4, 5};
    const Comparison noPanels{
        {withRms(Method::Natural, {}, all), withRms(Method::Wang2005, {}, all)}};
    EXPECT_FALSE(nearerThanLengthKeeping(noPanels));
    const Comparison onlyFree{{withRms(Method::Natural, 3, {})}};
    EXPECT_FALSE(nearerThanLengthKeeping(onlyFree));
}

}  // namespace
}  // namespace toile
