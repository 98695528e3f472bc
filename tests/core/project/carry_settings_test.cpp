// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/project/piece_settings.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/piece_edits.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// One flat panel of 300 x 300 mm that knows its source, and another beside it.
Garment twoPanels() {
    Garment garment;
    for (const double x : {0.0, 1000.0}) {
        MeshArrays mesh = test::planeGrid(10, 10, 30);
        mesh.V.col(0).array() += x;
        auto piece = std::make_shared<Piece>(*test::originalPiece(std::move(mesh)));
        piece->name = x == 0 ? "front" : "back";
        piece->file = x == 0 ? 0 : 1;
        test::identify(*piece, x == 0 ? 1 : 2);
        garment.pieces.push_back(std::move(piece));
    }
    garment.uncut = garment.pieces;
    return garment;
}

Garment cutAcrossFront(const Garment& garment) {
    LoadOptions options;
    options.seams.unit = LengthUnit::Millimetre;
    options.seams.cuts = {{"waist", UserCut::Kind::Path, {{0, 110, 0}, {300, 110, 0}}, false}};
    Progress progress;
    auto made = cutGarment(garment, options, progress);
    EXPECT_TRUE(made);
    return *made;
}

PieceResults resultsOf(const Garment& garment) {
    Progress progress;
    return flattenGarment(garment, {}, progress);
}

std::vector<PieceSettings> someSettings() {
    std::vector<PieceSettings> settings(2);
    settings[0].placement = Placement{{10, 20}, 0.5};
    settings[0].quantity = 4;
    settings[0].material = "Lining";
    settings[1].placement = Placement{{500, 20}, 0};
    settings[1].quantity = 2;
    return settings;
}

TEST(CarrySettings, TheSamePieceKeepsItsSettingsToTheBit) {
    const Garment garment = twoPanels();
    Garment turned = garment;
    std::swap(turned.pieces[0], turned.pieces[1]);
    const auto settings = someSettings();
    const auto carried =
        carriedSettings(carriedFrom(garment, settings, resultsOf(garment), turned), settings);
    EXPECT_EQ(carried[0], settings[1]);
    EXPECT_EQ(carried[1], settings[0]);
}

TEST(CarrySettings, BothPartsOfACutPieceKnowTheWhole) {
    const Garment garment = twoPanels();
    const PieceResults results = resultsOf(garment);
    const Garment cut = cutAcrossFront(garment);
    ASSERT_EQ(cut.pieces.size(), 3U);
    const auto settings = someSettings();
    const auto carried = carriedSettings(carriedFrom(garment, settings, results, cut), settings);
    for (std::size_t i = 0; i < 3; ++i) {
        const bool whole = cut.pieces[i]->name == "back";
        const PieceSettings& from = settings[whole ? 1 : 0];
        EXPECT_EQ(carried[i].placement, from.placement);
        EXPECT_EQ(carried[i].quantity, from.quantity);
        EXPECT_EQ(carried[i].material, from.material);
        EXPECT_EQ(carried[i].anchors.empty(), whole);
        EXPECT_EQ(carried[i].partOf, whole ? PieceId{} : garment.pieces[0]->id);
        EXPECT_LE(carried[i].anchors.size(), static_cast<std::size_t>(kMaxAnchors));
        // Anchors say where the vertex lay: the panel is flat, so that is where it is in space.
        for (const Anchor& a : carried[i].anchors) {
            for (const Anchor& b : carried[i].anchors) {
                const auto& V = cut.pieces[i]->mesh.V;
                EXPECT_NEAR((a.flat - b.flat).norm(), (V.row(a.vertex) - V.row(b.vertex)).norm(),
                            1e-6);
            }
        }
    }
}

TEST(CarrySettings, AWholePieceThatComesBackHasThePlaceOfItsLargerPart) {
    const Garment whole = twoPanels();
    const Garment cut = cutAcrossFront(whole);
    const PieceResults results = resultsOf(cut);
    std::vector<PieceSettings> settings(3);
    std::size_t larger = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        settings[i].quantity = static_cast<int>(i) + 1;
        if (cut.pieces[i]->name != "back" &&
            cut.pieces[i]->mesh.F.rows() > cut.pieces[larger]->mesh.F.rows()) {
            larger = i;
        }
    }
    const auto carried = carriedSettings(carriedFrom(cut, settings, results, whole), settings);
    EXPECT_EQ(carried[0].quantity, static_cast<int>(larger) + 1);
    EXPECT_FALSE(carried[0].anchors.empty());
}

TEST(CarrySettings, AnIdWinsOverNameAndSharedFaces) {
    const Garment garment = twoPanels();
    Garment renamed = garment;
    auto piece = std::make_shared<Piece>(*garment.pieces[0]);
    piece->id = garment.pieces[1]->id;
    renamed.pieces = {piece};
    EXPECT_EQ(carriedFrom(garment, {}, {}, renamed)[0].piece, 1);
}

TEST(CarrySettings, APieceOfNothingKnownIsNew) {
    const Garment garment = twoPanels();
    Garment other;
    auto piece = std::make_shared<Piece>(*garment.pieces[0]);
    test::identify(*piece, 3);
    other.pieces = {piece};
    const auto from = carriedFrom(garment, someSettings(), {}, other);
    EXPECT_EQ(from[0].piece, -1);
    EXPECT_EQ(carriedSettings(from, someSettings())[0], PieceSettings{});
}

TEST(CarrySettings, AnchorsGoThroughTwoEditsWithoutAFlatteningBetween) {
    const Garment garment = twoPanels();
    const auto first = carriedSettings(
        carriedFrom(garment, someSettings(), resultsOf(garment), cutAcrossFront(garment)),
        someSettings());
    const Garment cut = cutAcrossFront(garment);
    const Garment again = cutAcrossFront(garment);  // other pointers, nothing flat
    const auto second = carriedSettings(carriedFrom(cut, first, {}, again), first);
    ASSERT_EQ(first.size(), cut.pieces.size());
    ASSERT_EQ(second.size(), again.pieces.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(second[i], first[i]);
    }
}

}  // namespace
}  // namespace toile
