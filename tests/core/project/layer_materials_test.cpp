// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/layer_materials.h"

#include <gtest/gtest.h>

#include "tests/core/support/piece_edits.h"
#include "tests/core/support/shapes.h"

namespace toile {
namespace {

/// Panels of one file, each of one of these layers.
Garment ofLayers(const std::vector<int>& layers) {
    Garment garment;
    auto file = std::make_shared<SourceFile>();
    for (const int layer : layers) {
        auto piece = std::make_shared<Piece>(*test::originalPiece(test::planeGrid(2, 2, 30)));
        const auto faces = static_cast<std::size_t>(piece->mesh.F.rows());
        const auto first = static_cast<int>(file->reading.layerOfFace.size());
        piece->sourceFace.clear();
        for (std::size_t f = 0; f < faces; ++f) {
            piece->sourceFace.push_back(first + static_cast<int>(f));
        }
        file->reading.layerOfFace.insert(file->reading.layerOfFace.end(), faces, layer);
        garment.pieces.push_back(std::move(piece));
    }
    garment.files = {std::move(file)};
    return garment;
}

TEST(LayerMaterials, AnInnerLayerIsALining) {
    const Garment garment = ofLayers({1, 0, 1});
    EXPECT_EQ(layersOf(garment), (std::vector<int>{1, 0, 1}));
    const std::vector<PieceSettings> settings = usualSettings(garment);
    EXPECT_EQ(settings[0].material, "Lining");
    EXPECT_EQ(settings[1], PieceSettings{});
    EXPECT_EQ(settings[2].material, "Lining");
}

TEST(LayerMaterials, SeveralInnerLayersAreNumberedFromOutside) {
    const std::vector<Wording> materials = usualMaterials(ofLayers({2, 0, 1}));
    EXPECT_EQ(materials[0], "Layer 3");
    EXPECT_EQ(materials[1], "");
    EXPECT_EQ(materials[2], "Layer 2");
}

TEST(LayerMaterials, OneLayerIsTheGarmentsFabric) {
    Garment garment = ofLayers({0, 0});
    EXPECT_TRUE(layersOf(garment).empty());
    EXPECT_EQ(usualSettings(garment), std::vector<PieceSettings>(2));
    auto plain = std::make_shared<SourceFile>();
    garment.files = {plain};
    EXPECT_TRUE(layersOf(garment).empty());
}

TEST(LayerMaterials, ListKeepsWhatIsUsedAndWhatHasAFabric) {
    const Fabric own = *fabricPreset("denim"), other = *fabricPreset("jersey");
    const MaterialList known = {{"Felt", other}, {"Gone", own}, {"Shell", own}};
    const MaterialList used = materialsInUse(known, {"Shell", "", "Lining", "Lining"}, own);
    EXPECT_EQ(used, (MaterialList{{"Felt", other}, {"Shell", own}, {"Lining", own}}));
}

}  // namespace
}  // namespace toile
