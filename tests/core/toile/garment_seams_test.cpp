// SPDX-License-Identifier: GPL-3.0-or-later
// What Toile exists for, on whole garments: both sides of every seam come out equally long.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "core/formats/export_file.h"
#include "core/pattern/pattern.h"
#include "core/seam/seam_measure.h"
#include "core/seam/seam_settings.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/sewn_sample.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

constexpr double kEqual = 1e-6;  // mm

struct Flat {
    Garment garment;
    PieceResults results;
};

Flat flattenFile(const std::filesystem::path& path, const LoadOptions& load,
                 Method method = Method::Wang2005) {
    Progress progress;
    auto garment = loadGarment({path}, load, progress);
    EXPECT_TRUE(garment) << (garment ? "" : sentence(garment.error()));
    Flat flat;
    if (garment) {
        flat.garment = std::move(*garment);
        FlattenOptions options;
        options.method = method;
        flat.results = flattenGarment(flat.garment, options, progress);
    }
    return flat;
}

/// One entry per seam, free edges aside. Every piece must be flat.
std::vector<std::pair<const Seam*, SeamMeasure>> ledger(const Flat& flat) {
    std::vector<std::pair<const Seam*, SeamMeasure>> rows;
    for (const Seam& seam : flat.garment.seams.seams) {
        if (seam.kind != SeamKind::Free) {
            const PieceResult& left = *flat.results[seam.left.piece];
            const PieceResult& right = *flat.results[seam.right.piece];
            rows.emplace_back(
                &seam, measureSeam(seam, *left.piece, *left.flat, *right.piece, *right.flat));
        }
    }
    return rows;
}

void expectAllFlat(const Flat& flat) {
    for (const auto& result : flat.results) {
        EXPECT_TRUE(result->flat) << sentence(*result->error);
    }
}

struct Welded {
    const char* name;
    std::size_t seams;  ///< at least
    double worstConformal =
        4;  ///< mm that a conformal map leaves at least; 4 are red in the ledger
};

class WeldedGarments : public testing::TestWithParam<Welded> {};

TEST_P(WeldedGarments, SewWithoutADifferenceAndWouldNotUnderAConformalMap) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path =
        test::garmentWithTruth(GetParam().name, folder.path()).string() + ".obj";
    TOILE_NEEDS_SHARED(path);
    LoadOptions load;
    load.split = SplitMode::Uv;
    load.unit = LengthUnit::Centimetre;
    const Flat exact = flattenFile(path, load);
    expectAllFlat(exact);
    const auto rows = ledger(exact);
    EXPECT_GE(rows.size(), GetParam().seams);
    for (const auto& [seam, measure] : rows) {
        if (seam->gap == 0) {
            EXPECT_LE(std::abs(measure.deltaMm), kEqual) << seam->name;
            EXPECT_NEAR(measure.length2dLeft, measure.length3d[0], kEqual) << seam->name;
        }
        EXPECT_LE(std::abs(measure.errorMm), kEqual) << seam->name;
    }
    const Flat natural = flattenFile(path, load, Method::Natural);
    expectAllFlat(natural);
    double worst = 0;
    for (const auto& row : ledger(natural)) {
        worst = std::max(worst, std::abs(row.second.errorMm));
    }
    EXPECT_GT(worst, GetParam().worstConformal);
}

INSTANTIATE_TEST_SUITE_P(Samples, WeldedGarments,
                         testing::Values(Welded{"samples/tshirt", 14}, Welded{"samples/bodice", 11},
                                         Welded{"samples/trousers", 11},
                                         Welded{"samples/cap", 10, 1},
                                         Welded{"samples/skirt", 14, 0.2}));
INSTANTIATE_TEST_SUITE_P(Shared, WeldedGarments,
                         testing::Values(Welded{"dress", 26}, Welded{"longsleeve", 14},
                                         Welded{"polo", 17}, Welded{"tee_sim", 12},
                                         Welded{"tshirt", 10}));

void expectEaseAndNoError(const Flat& flat, std::size_t seams) {
    const auto rows = ledger(flat);
    EXPECT_GE(rows.size(), seams);
    double largestEase = 0;
    for (const auto& [seam, measure] : rows) {
        largestEase = std::max(largestEase, std::abs(measure.ease));
        EXPECT_LE(std::abs(measure.errorMm), kEqual) << seam->name;
    }
    EXPECT_GT(largestEase, 0.02);
}

TEST(GarmentSeams, AGatheredSideShowsEaseAndNoError) {
    // A strip of 400 mm, and below it one whose upper edge waves out of the plane.
    const int fine = 160;
    std::string text = "o strip\n";
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column <= fine; ++column) {
            const double wave = row == 1 ? 1.5 * std::sin(std::numbers::pi / 2 * column) : 0;
            const double y = row < 2 ? 100.0 * row : 100.0 * (row - 1);
            text += "v " + std::to_string(2.5 * column) + ' ' + std::to_string(y) + ' ' +
                    std::to_string(wave) + '\n';
        }
    }
    for (const int row : {0, 2}) {
        text += row == 0 ? "o gathered\n" : "o plain\n";
        for (int column = 1; column <= fine; ++column) {
            const int a = row * (fine + 1) + column, b = a + fine + 1;
            text += "f " + std::to_string(a) + ' ' + std::to_string(a + 1) + ' ' +
                    std::to_string(b + 1) + "\nf " + std::to_string(a) + ' ' +
                    std::to_string(b + 1) + ' ' + std::to_string(b) + '\n';
        }
    }
    const test::TemporaryFolder folder;
    LoadOptions load;
    load.unit = LengthUnit::Millimetre;
    expectEaseAndNoError(flattenFile(folder.write("a.obj", text), load), 1);
}

TEST(GarmentSeams, AGatheredSkirtShowsEaseAndNoError) {
    const auto path = test::sharedFile("garments/dress14_pieces.obj");
    TOILE_NEEDS_SHARED(path);
    expectEaseAndNoError(flattenFile(path, {}), 21);
}

/// Our own trousers as one surface, in centimetres and without names, as leggings are.
std::filesystem::path seamlessTrousers(const test::TemporaryFolder& folder) {
    return test::writeSewnSample("trousers", folder.path()).string() + ".obj";
}

LoadOptions asOnePiece() {
    LoadOptions load;
    load.unit = LengthUnit::Centimetre;
    load.split = SplitMode::Components;
    return load;
}

/// @param length  mm, of every cut
void expectOpenByThemselves(const Flat& legs, double length, double tolerance) {
    expectAllFlat(legs);
    ASSERT_EQ(legs.garment.cuts.size(), 2U);
    for (const AppliedCut& cut : legs.garment.cuts) {
        EXPECT_EQ(cut.author, CutAuthor::Automatic);
        EXPECT_NEAR(cut.length, length, tolerance);
    }
    const auto rows = ledger(legs);
    EXPECT_GE(rows.size(), 2U);
    for (const auto& [seam, measure] : rows) {
        EXPECT_LE(std::abs(measure.deltaMm), kEqual) << seam->name;
    }
}

TEST(GarmentSeams, SeamlessTrousersOpenByThemselves) {
    const test::TemporaryFolder folder;
    LoadOptions load = asOnePiece();
    load.autoCut = true;
    expectOpenByThemselves(flattenFile(seamlessTrousers(folder), load), 1000, 100);
}

TEST(GarmentSeams, LeggingsOpenByThemselves) {
    const auto path = test::sharedFile("garments/leggings.ply");
    TOILE_NEEDS_SHARED(path);
    LoadOptions load;
    load.autoCut = true;
    expectOpenByThemselves(flattenFile(path, load), 935, 5);
}

/// Cut along the middle and along both inseams, by the names of tests/data/leggings.seams.json.
void expectTwoLegsWithOneInseamEach(const Flat& legs) {
    expectAllFlat(legs);
    EXPECT_TRUE(legs.garment.problems.empty());
    EXPECT_EQ(legs.garment.pieces.size(), 2U);
    EXPECT_EQ(legs.garment.cuts.size(), 3U);
    int inseams = 0, between = 0;
    std::vector<std::string> names;
    for (const auto& [seam, measure] : ledger(legs)) {
        names.push_back(seam->name);
        (seam->left.piece == seam->right.piece ? inseams : between) += 1;
        EXPECT_LE(std::abs(measure.deltaMm), kEqual) << seam->name;
    }
    EXPECT_EQ(inseams, 2);
    EXPECT_EQ(between, 2);  // front and back, from the waist to the crotch
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"centre front and back 1", "centre front and back 2",
                                               "left inseam", "right inseam"}));
}

TEST(GarmentSeams, AHandWrittenFileMakesTwoLegsWithOneInseamEach) {
    const auto path = test::sharedFile("garments/leggings.ply");
    TOILE_NEEDS_SHARED(path);
    const auto seams = readSeamsFile(test::sourceFile("tests/data/leggings.seams.json"));
    ASSERT_TRUE(seams) << sentence(seams.error());
    LoadOptions load;
    load.split = SplitMode::Seams;
    load.seams = *seams;
    expectTwoLegsWithOneInseamEach(flattenFile(path, load));
}

TEST(GarmentSeams, CutsThroughTheCrotchMakeTwoLegsWithOneInseamEach) {
    const test::TemporaryFolder folder;
    const auto path = seamlessTrousers(folder);
    LoadOptions load = asOnePiece();
    Progress progress;
    const auto whole = loadGarment({path}, load, progress);
    ASSERT_TRUE(whole);
    const Points3 V = whole->pieces.at(0)->mesh.V / 10;
    std::vector<Eigen::Vector3d> middle;
    Eigen::Vector3d leftHem(0, HUGE_VAL, 0);  // the innermost of the lowest
    for (const auto& p : V.rowwise()) {
        if (std::abs(p.x()) < 1e-6) {
            middle.emplace_back(p.transpose());
        }
        if (p.x() > 0 &&
            (p.y() < leftHem.y() - 1e-6 || (p.y() < leftHem.y() + 1e-6 && p.x() < leftHem.x()))) {
            leftHem = p.transpose();
        }
    }
    const Eigen::Vector3d crotch =
        *std::ranges::min_element(middle, {}, [](const auto& p) { return p.y(); });
    std::vector<Eigen::Vector3d> front, back;
    for (const Eigen::Vector3d& p : middle) {
        (p.z() > crotch.z() ? front : back).push_back(p);
    }
    const auto above = [](const auto& p) { return p.y(); };
    std::ranges::sort(front, std::greater(), above);
    std::ranges::sort(back, std::less(), above);
    ASSERT_FALSE(front.empty() || back.empty());
    std::vector<Eigen::Vector3d> across = front;
    if (back.front() != crotch) {
        across.push_back(crotch);
    }
    across.insert(across.end(), back.begin(), back.end());
    const Eigen::Vector3d rightHem(-leftHem.x(), leftHem.y(), leftHem.z());
    load.split = SplitMode::Seams;
    load.seams.cuts = {{"centre front and back", UserCut::Kind::Path, across},
                       {"right inseam", UserCut::Kind::Path, {crotch, rightHem}},
                       {"left inseam", UserCut::Kind::Path, {crotch, leftHem}}};
    expectTwoLegsWithOneInseamEach(flattenFile(path, load));
}

TEST(GarmentSeams, ASuitWithoutSeamsOpensByItself) {
    const auto path = test::sharedFile("garments/suit_mh.obj");
    TOILE_NEEDS_SHARED(path);
    LoadOptions load;
    load.autoCut = true;
    const Flat suit = flattenFile(path, load);
    EXPECT_EQ(suit.garment.files[0]->split.mode, SplitMode::Components);  // an artist's UV map
    expectAllFlat(suit);
    // Five cuts open the two parts; a sixth keeps the flat outline from crossing itself.
    EXPECT_EQ(suit.garment.pieces.size(), 3U);
    EXPECT_EQ(suit.garment.cuts.size(), 6U);
}

TEST(GarmentSeams, ASeamlessShirtOpensByItself) {
    const test::TemporaryFolder folder;
    LoadOptions load = asOnePiece();
    load.autoCut = true;
    const auto path = test::writeSewnSample("tshirt", folder.path()).string() + ".obj";
    const Flat shirt = flattenFile(path, load);
    expectAllFlat(shirt);
    EXPECT_EQ(shirt.garment.pieces.size(), 1U);
    EXPECT_EQ(shirt.garment.cuts.size(), 3U);  // four openings
}

/// Two squares of 10 x 10 mm with a common edge, as two objects.
constexpr const char* kTwoSquares =
    "v 0 0 0\nv 10 0 0\nv 20 0 0\nv 0 10 0\nv 10 10 0\nv 20 10 0\n"
    "o left\nf 1 2 5 4\no right\nf 2 3 6 5\n";

TEST(GarmentSeams, EaseIsStatedByName) {
    const test::TemporaryFolder folder;
    LoadOptions load;
    load.unit = LengthUnit::Millimetre;
    load.seams.ease = {{"left / right", 0.25}, {"left / sleeve", 0.1}};
    const Flat flat = flattenFile(folder.write("a.obj", kTwoSquares), load);
    const auto rows = ledger(flat);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].first->ease, 0.25);
    EXPECT_NEAR(rows[0].second.errorMm, -2.5, 1e-12);
    ASSERT_EQ(flat.garment.problems.size(), 1U);
    EXPECT_EQ(flat.garment.problems[0].code, ErrorCode::NoSuchSeam);
    EXPECT_EQ(flat.garment.problems[0].subject.name, "left / sleeve");
}

TEST(GarmentSeams, CuttingAnewKeepsThePiecesWithoutCuts) {
    const test::TemporaryFolder folder;
    Progress progress;
    LoadOptions load;
    load.unit = LengthUnit::Millimetre;
    const auto before = loadGarment({folder.write("a.obj", kTwoSquares)}, load, progress);
    ASSERT_TRUE(before);
    load.seams.cuts = {{"across", UserCut::Kind::Path, {{12, 5, 0}, {20, 5, 0}}, false}};
    const auto after = cutGarment(*before, load, progress);
    ASSERT_TRUE(after);
    EXPECT_EQ(after->pieces[0], before->pieces[0]);
    EXPECT_NE(after->pieces[1], before->pieces[1]);
    EXPECT_EQ(after->uncut, before->uncut);
    EXPECT_EQ(after->cuts.size(), 1U);
    const auto undone = cutGarment(*after, {}, progress);
    ASSERT_TRUE(undone);
    EXPECT_EQ(undone->pieces, before->pieces);
}

TEST(GarmentSeams, ASecondCutKeepsThePiecesOfTheFirst) {
    const test::TemporaryFolder folder;
    Progress progress;
    LoadOptions load;
    load.unit = LengthUnit::Millimetre;
    load.seams.cuts = {{"right", UserCut::Kind::Path, {{12, 5, 0}, {20, 5, 0}}, false}};
    const auto before = loadGarment({folder.write("a.obj", kTwoSquares)}, load, progress);
    ASSERT_TRUE(before);
    load.seams.cuts.push_back({"left", UserCut::Kind::Path, {{2, 5, 0}, {8, 5, 0}}, false});
    const auto after = cutGarment(*before, load, progress);
    ASSERT_TRUE(after);
    EXPECT_NE(after->pieces[0], before->pieces[0]);
    EXPECT_EQ(after->pieces.back(), before->pieces.back());
    EXPECT_NE(before->pieces.back(), before->uncut.back());  // a cut one
}

/// A triangle drawn on the surface of a piece, about its middle.
UserCut loopOn(const Piece& piece, double size) {
    const Points3& V = piece.mesh.V;
    const Eigen::RowVector3d middle = V.colwise().mean();
    Eigen::Index nearest = 0;
    (V.rowwise() - middle).rowwise().squaredNorm().minCoeff(&nearest);
    const Eigen::Vector3d at = V.row(nearest).transpose();
    return {"loop",
            UserCut::Kind::Loop,
            {at + size * Eigen::Vector3d(-1, -0.5, 0), at + size * Eigen::Vector3d(1, -0.5, 0),
             at + size * Eigen::Vector3d(0, 1, 0)},
            false};
}

void expectPatchIsSewn(const std::filesystem::path& path, std::size_t which) {
    LoadOptions load;
    load.seams.unit = LengthUnit::Millimetre;
    Progress progress;
    const auto whole = loadGarment({path}, load, progress);
    ASSERT_TRUE(whole);
    std::size_t sewnBefore = 0;
    for (const Seam& seam : whole->seams.seams) {
        sewnBefore += seam.kind != SeamKind::Free;
    }
    load.seams.cuts = {loopOn(*whole->uncut[which], 50)};
    load.seams.ease = {{"loop", 0.02}};
    Flat flat;
    auto made = cutGarment(*whole, load, progress);
    ASSERT_TRUE(made);
    flat.garment = std::move(*made);
    flat.results = flattenGarment(flat.garment, {}, progress);
    ASSERT_EQ(flat.garment.pieces.size(), whole->pieces.size() + 1);
    const auto rows = ledger(flat);
    EXPECT_EQ(rows.size(), sewnBefore + 1);
    const auto row = std::ranges::find_if(
        rows, [](const auto& entry) -> bool { return entry.first->name == "loop"; });
    ASSERT_NE(row, rows.end());
    const auto& [seam, measure] = *row;
    EXPECT_TRUE(seam->closed);
    EXPECT_EQ(seam->ease, 0.02);
    EXPECT_NEAR(seam->length3d[0], seam->length3d[1], kEqual);
    EXPECT_NE(seam->left.loop > 0, seam->right.loop > 0);
    // Rim and patch have the length they have on the garment: the ease that was asked for is all.
    EXPECT_NEAR(measure.length2dLeft, seam->length3d[0], kEqual);
    EXPECT_NEAR(measure.length2dRight, seam->length3d[0], kEqual);
    // Both pieces bear the seam's number on the paper.
    for (const SeamSide& side : {seam->left, seam->right}) {
        const PatternPiece drawn =
            makePattern(flat.garment, flat.results).pieces[static_cast<std::size_t>(side.piece)];
        EXPECT_EQ(std::ranges::count(drawn.seams, std::string("loop"), &SeamLine::name), 1);
    }
    EXPECT_EQ(seam->cuts, std::vector{flat.garment.cuts.front().id});
}

class PatchedGarments : public testing::TestWithParam<std::pair<const char*, std::size_t>> {};

TEST_P(PatchedGarments, HaveThePatchSewnToItsHole) {
    const auto path = test::dataFile(GetParam().first);
    TOILE_NEEDS_SHARED(path);
    expectPatchIsSewn(path, GetParam().second);
}

INSTANTIATE_TEST_SUITE_P(Samples, PatchedGarments,
                         testing::Values(std::pair("samples/tshirt.obj", 0),
                                         std::pair("samples/tshirt.obj", 1)));
INSTANTIATE_TEST_SUITE_P(Shared, PatchedGarments,
                         testing::Values(std::pair("garments/tee_sim.obj", 4)));

TEST(GarmentSeams, CutsFollowTheUnitAndTheAxesOfTheFile) {
    const test::TemporaryFolder folder;
    // The same squares standing in a file where z is up, in cm.
    const auto path = folder.write("a.obj",
                                   "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 0 1\nv 1 0 1\nv 2 0 1\n"
                                   "o left\nf 1 2 5 4\no right\nf 2 3 6 5\n");
    LoadOptions load;
    load.unit = LengthUnit::Centimetre;
    load.up = UpAxis::Z;
    load.seams.cuts = {{"across", UserCut::Kind::Path, {{1.2, 0, 0.5}, {2, 0, 0.5}}, false}};
    const Flat flat = flattenFile(path, load);
    ASSERT_EQ(flat.garment.cuts.size(), 1U);
    EXPECT_NEAR(flat.garment.cuts[0].length, 8, 0.2);
    EXPECT_EQ(flat.garment.pieces[0]->mesh.V.col(1).maxCoeff(), 10);
    ASSERT_TRUE(exportFile(folder / "out.obj",
                           {flat.garment, flat.results, inRows(flat.garment, flat.results)}));
    const auto again = flattenFile(folder / "out.obj", {LengthUnit::Centimetre, UpAxis::Z});
    double area = 0;
    for (const auto& result : again.results) {
        ASSERT_TRUE(result->quality);
        area += result->quality->area3d;
    }
    EXPECT_NEAR(area, 200, 1e-9);
}

}  // namespace
}  // namespace toile
