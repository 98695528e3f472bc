// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of a proof, to people and to programs.
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/prove/pattern_faults.h"
#include "core/prove/proof.h"

namespace toile {
namespace {

/// A square of two triangles and its mirror image, sewn along one side each.
Garment twoSquares() {
    Garment garment;
    for (const char* name : {"front", "back"}) {
        auto piece = std::make_shared<Piece>();
        piece->name = name;
        piece->mesh.V.resize(4, 3);
        piece->mesh.V << 0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 0;
        piece->mesh.F.resize(2, 3);
        piece->mesh.F << 0, 1, 2, 0, 2, 3;
        piece->boundary = {0, 1, 2, 3};
        garment.pieces.push_back(piece);
    }
    Seam seam;
    seam.name = "side left";
    seam.left = {.piece = 0, .first = 0, .count = 1, .start = 0, .end = 100};
    seam.right = {.piece = 1, .first = 3, .count = 2, .reversed = true, .start = 450, .end = 350};
    garment.seams.seams.push_back(seam);
    return garment;
}

/// Sewn `factor` times as large as it was designed.
Proof proofOfSquares(const Garment& garment, double factor) {
    Proof proof;
    for (const auto& piece : garment.pieces) {
        ProvenPiece& proven = proof.pieces.emplace_back();
        proven.sewn = factor * piece->mesh.V;
        proven.gap = proven.strain = Eigen::VectorXd::Zero(4);
        proof.fabrics.push_back(fabricPresets().front());
    }
    proof.gap = {0.34, 1.42, 3, 2};
    proof.gapPiece = 1;
    proof.seams.push_back({.seam = 0, .left = 100, .right = 100});
    return proof;
}

TEST(ProofWords, NameTheSeamThatPullsMost) {
    const Garment garment = twoSquares();
    Proof proof = proofOfSquares(garment, 1);
    EXPECT_EQ(sentence(proof, garment),
              "The sewn pattern is 0.3 mm from the design on average, 95 % within 1.4 mm");
    proof.pieces[1].mostPull = 0.02;
    proof.pieces[0].mostSlack = 0.03;
    EXPECT_TRUE(sentence(proof, garment).ends_with(": front, 3.0 % slack"));
    proof.pieces[1].mostPull = 0.04;
    EXPECT_TRUE(sentence(proof, garment).ends_with(": back, 4.0 %"));
    proof.seams[0].strain = 0.031;
    EXPECT_TRUE(sentence(proof, garment).ends_with(": side left, 3.1 %"));
    proof.freeShare = 0.25;
    EXPECT_TRUE(sentence(proof, garment).ends_with(", 3.1 %. 25 % hangs free"));
}

TEST(ProofWords, BeginWithClothThatHasNotSettled) {
    const Garment garment = twoSquares();
    Proof proof = proofOfSquares(garment, 1);
    proof.iterations = 200;
    EXPECT_TRUE(
        std::string(sentence(proof, garment))
            .starts_with("Not settled after 200 steps, so all figures are rough. The sewn"));
    proof.hasSettled = true;
    EXPECT_TRUE(std::string(sentence(proof, garment)).starts_with("The sewn pattern"));
}

TEST(ProofWords, SayWhetherTheFabricGives) {
    const Garment garment = twoSquares();
    Proof proof = proofOfSquares(garment, 1);
    proof.seams[0].strain = 0.031;
    const auto said = [&](const char* fabric) {
        proof.fabrics.assign(2, *fabricPreset(fabric));
        return std::string(sentence(proof, garment));
    };
    EXPECT_TRUE(said("spandex").ends_with(", 3.1 %, which the fabric allows"));
    EXPECT_TRUE(said("woven").ends_with(", 3.1 %"));  // on the bias alone
    proof.seams[0].strain = 0.09;
    EXPECT_TRUE(said("woven").ends_with(", 9.0 %, more than the fabric allows"));
}

TEST(SeamStrain, IsThatOfItsTwoSides) {
    const Garment garment = twoSquares();
    const Proof larger = proofOfSquares(garment, 1.02);
    EXPECT_NEAR(prove::seamStrain(garment, larger.seams[0], larger.pieces), 0.02, 1e-12);
    Proof one = larger;
    one.pieces[1] = {};
    one.seams[0].left = 51;
    EXPECT_NEAR(prove::seamStrain(garment, one.seams[0], one.pieces), 1, 1e-12);
    one.pieces[0] = {};
    EXPECT_EQ(prove::seamStrain(garment, one.seams[0], one.pieces), 0);
}

TEST(ProofWords, HowItWasHeldIsToldAsItWasAsked) {
    Proof proof;
    EXPECT_EQ(howHeld(proof), "on the design, 10 Pa");
    proof.settings.pressure = -0.25;
    proof.hasBody = true;
    EXPECT_EQ(howHeld(proof), "on a body, -0.25 Pa");
    proof.bodyName = "avatar.obj";
    proof.settings.hasGravity = true;
    proof.settings.touchesItself = true;
    proof.scale = 0.97;
    proof.settings.stiffness.shear = 20;
    EXPECT_EQ(howHeld(proof),
              "on avatar.obj, -0.25 Pa, gravity, 1 mm between layers, scaled by 0.97, own "
              "stiffness values");
}

TEST(ProofWriter, WritesWhatWasFoundAndNeverNaN) {
    const Garment garment = twoSquares();
    Proof proof = proofOfSquares(garment, 1);
    proof.pieces[0] = {};
    proof.pieces[1].gapFigures.max = std::numeric_limits<double>::quiet_NaN();
    Finding fault;
    fault.kind = FindingKind::SeamSlips;
    fault.subject = Subject::seam("side left");
    fault.pieces = {0, 1};
    fault.seam = 0;
    fault.badness = 10;
    fault.reason = "the sides of side left do not fit";
    proof.faults.push_back(fault);
    const auto json = nlohmann::json::parse(writeProof(garment, proof));
    EXPECT_EQ(json["gap_mm"]["mean"], 0.34);
    EXPECT_EQ(json["gap_mm"]["p95"], 1.42);
    EXPECT_EQ(json["gap_mm"]["piece"], "back");
    EXPECT_EQ(json["gap_mm"]["vertex"], 2);
    EXPECT_TRUE(json["strain"]["piece"].is_null());
    EXPECT_EQ(json["pieces"][0]["sewn"], false);
    EXPECT_TRUE(json["pieces"][1]["gap_mm"]["max"].is_null());
    EXPECT_EQ(json["seams"][0]["name"], "side left");
    EXPECT_EQ(json["faults"][0]["code"], "seam-slips");
    EXPECT_EQ(json["faults"][0]["pieces"], nlohmann::json({"front", "back"}));
    EXPECT_EQ(json["faults"][0]["sentence"], "the sides of side left do not fit");
    for (const char* key :
         {"version", "sentence", "free_share", "source", "held", "edge_mm", "triangles",
          "iterations", "rest_force_n", "seam_force_n", "share", "settled", "seconds"}) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
}

}  // namespace
}  // namespace toile
