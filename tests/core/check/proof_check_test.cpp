// SPDX-License-Identifier: GPL-3.0-or-later
// What a proof adds to "ready to cut?".
#include <gtest/gtest.h>

#include "core/prove/proof.h"
#include "core/seam/find_seams.h"
#include "tests/core/check/cut_plans.h"

namespace toile {
namespace {

/// Sewn where it was designed, but for a gap.
std::shared_ptr<Proof> proofWithGap(const CutPlan& plan, double mean) {
    auto proof = std::make_shared<Proof>();
    for (const auto& piece : plan.garment->pieces) {
        ProvenPiece& proven = proof->pieces.emplace_back();
        proven.sewn = piece->mesh.V;
        proven.gapFigures = {mean, 2 * mean, 3 * mean, 0};
    }
    proof->gap = {mean, 2 * mean, 3 * mean, 0};
    proof->gapPiece = 0;
    proof->hasSettled = true;
    return proof;
}

CutPlan provedPlan(std::shared_ptr<const Proof> proof) {
    CutPlan plan = test::readyPlan();
    plan.proof = std::move(proof);
    return plan;
}

TEST(ProofCheck, AGapIsADoubtFromTwoMillimetresOn) {
    const CutPlan plan = test::readyPlan();
    EXPECT_EQ(readyToCut(provedPlan(proofWithGap(plan, 1.99))).verdict(), Verdict::Ready);
    const Readiness readiness = readyToCut(provedPlan(proofWithGap(plan, kDoubtfulGap)));
    EXPECT_EQ(readiness.verdict(), Verdict::Doubts);
    EXPECT_EQ(readiness.findings.size(), 1U);
    EXPECT_EQ(test::findingsOf(readiness, FindingKind::SewnGap).size(), 1U);
}

TEST(ProofCheck, ClothThatHasNotComeToRestIsADoubtInPlaceOfItsGap) {
    for (const double gap : {0.1, 50.0}) {
        auto proof = proofWithGap(test::readyPlan(), gap);
        proof->hasSettled = false;
        const Readiness readiness = readyToCut(provedPlan(proof));
        EXPECT_EQ(readiness.verdict(), Verdict::Doubts);
        ASSERT_EQ(readiness.findings.size(), 1U);
        EXPECT_EQ(readiness.findings[0].kind, FindingKind::ProofFault);
        EXPECT_FALSE(readiness.findings[0].reason.empty());
    }
}

TEST(ProofCheck, ALengthThatDiffersIsADoubt) {
    auto proof = proofWithGap(test::readyPlan(), 0.1);
    Finding longer;
    longer.kind = FindingKind::LengthDiffers;
    longer.severity = Severity::Doubt;
    longer.reason = "side left is 3.0 mm longer in the pattern than on the design";
    proof->faults = {longer};
    EXPECT_EQ(readyToCut(provedPlan(proof)).verdict(), Verdict::Doubts);
}

TEST(ProofCheck, AGapNamesThePieceThatIsFarthestOffAndThePlace) {
    auto proof = proofWithGap(test::readyPlan(), 3);
    proof->pieces[1].gapFigures = {4.5, 9, 12, 8};
    const CutPlan plan = provedPlan(proof);
    const auto found = test::findingsOf(readyToCut(plan), FindingKind::SewnGap);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].pieces, std::vector{1});
    ASSERT_TRUE(found[0].place);
    EXPECT_EQ(found[0].place->position.transpose(), plan.garment->pieces[1]->mesh.V.row(8));
    EXPECT_EQ(found[0].subject.name, "back");
    ASSERT_EQ(found[0].figures.size(), 3U);
    EXPECT_DOUBLE_EQ(found[0].figures[0].value, 3);
    EXPECT_DOUBLE_EQ(found[0].figures[1].value, 6);
    EXPECT_DOUBLE_EQ(found[0].figures[2].value, 4.5);
}

TEST(ProofCheck, APieceWithoutClothIsNotTheFarthest) {
    auto proof = proofWithGap(test::readyPlan(), 3);
    proof->pieces[0] = {};
    const auto found = test::findingsOf(readyToCut(provedPlan(proof)), FindingKind::SewnGap);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].pieces, std::vector{1});
}

TEST(ProofCheck, WrongPiecesAreFaultsInTheProofsOwnWords) {
    auto proof = proofWithGap(test::readyPlan(), 0.1);
    Finding mirrored;
    mirrored.kind = FindingKind::Mirrored;
    mirrored.subject = Subject::piece("front", {1});
    mirrored.pieces = {0};
    mirrored.severity = Severity::Fault;
    mirrored.reason = "front is mirrored in the pattern";
    proof->faults = {mirrored};
    const Readiness readiness = readyToCut(provedPlan(proof));
    EXPECT_EQ(readiness.verdict(), Verdict::Faults);
    ASSERT_EQ(readiness.findings.size(), 1U);
    EXPECT_TRUE(sentence(readiness.findings[0]).starts_with("front is mirrored in the pattern. "))
        << sentence(readiness.findings[0]);
}

TEST(ProofCheck, APieceThatIsNotFlatIsNotToldTwice) {
    auto proof = proofWithGap(test::readyPlan(), 0.1);
    Finding missing;
    missing.kind = FindingKind::NotThere;
    missing.severity = Severity::Fault;
    missing.pieces = {0};
    proof->faults = {missing};
    CutPlan plan = provedPlan(proof);
    EXPECT_EQ(test::findingsOf(readyToCut(plan), FindingKind::NotThere).size(), 1U);
    auto leftOut = test::copyOfResult(plan, 0);
    leftOut->flat.reset();
    leftOut->error = Error{ErrorCode::LeftOut};
    plan.results[0] = leftOut;
    EXPECT_TRUE(test::findingsOf(readyToCut(plan), FindingKind::NotThere).empty());
}

TEST(ProofCheck, SeamsThatSlipAreToldOnce) {
    // Two sheets that lie edge to edge; one flat side is made longer.
    MeshArrays left = test::planeGrid(4, 4, 50), right = left;
    right.V.col(0).array() += 200;
    CutPlan plan = test::readyPlan({"left", "right"});
    auto garment = std::make_shared<Garment>(*plan.garment);
    garment->pieces = {std::make_shared<const Piece>(makePiece("left", left)),
                       std::make_shared<const Piece>(makePiece("right", right))};
    garment->seams = findSeams(garment->pieces);
    plan.garment = garment;
    for (std::size_t i = 0; i < 2; ++i) {
        auto result = test::copyOfResult(plan, i);
        result->piece = garment->pieces[i];
        result->flat->Q = result->piece->mesh.V.leftCols<2>();
        plan.results[i] = result;
    }
    auto proof = proofWithGap(plan, 0.1);
    Finding slips;
    slips.kind = FindingKind::SeamSlips;
    slips.seam = 0;
    slips.pieces = {0, 1};
    slips.severity = Severity::Fault;
    slips.badness = 5;
    proof->faults = {slips};
    plan.proof = proof;
    // The pattern that was sewn has a fault that the flat pieces do not show.
    EXPECT_EQ(test::findingsOf(readyToCut(plan), FindingKind::SeamSlips).size(), 1U);
    auto longer = test::copyOfResult(plan, 1);
    longer->flat->Q.col(1) *= 1 + 5 / 200.0;
    plan.results[1] = longer;
    EXPECT_TRUE(test::findingsOf(readyToCut(plan), FindingKind::SeamSlips).empty());
    EXPECT_EQ(test::findingsOf(readyToCut(plan), FindingKind::SeamLengths).size(), 1U);
}

TEST(ProofCheck, TheProofOfAnotherGarmentSaysNothing) {
    auto proof = proofWithGap(test::readyPlan(), 50);
    proof->pieces.resize(1);
    EXPECT_EQ(readyToCut(provedPlan(proof)).verdict(), Verdict::Ready);
}

}  // namespace
}  // namespace toile
