// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/layer_materials.h"

#include <algorithm>
#include <utility>

namespace toile {

int layerCount(const FileReading& reading) {
    return reading.layerOfFace.empty() ? 1 : 1 + *std::ranges::max_element(reading.layerOfFace);
}

std::vector<int> layersOf(const Garment& garment) {
    if (std::ranges::all_of(garment.files,
                            [](const auto& file) { return layerCount(file->reading) == 1; })) {
        return {};
    }
    std::vector<int> layers;
    for (const auto& piece : garment.pieces) {
        const auto& layerOfFace =
            garment.files[static_cast<std::size_t>(piece->file)]->reading.layerOfFace;
        const std::size_t first =
            piece->sourceFace.empty() ? 0 : static_cast<std::size_t>(piece->sourceFace.front());
        layers.push_back(first < layerOfFace.size() ? layerOfFace[first] : 0);
    }
    return layers;
}

std::vector<Wording> usualMaterials(const Garment& garment) {
    std::vector<int> count;
    for (const auto& file : garment.files) {
        count.push_back(layerCount(file->reading));
    }
    const std::vector<int> layers = layersOf(garment);
    std::vector<Wording> usual(garment.pieces.size());
    for (std::size_t p = 0; p < layers.size(); ++p) {
        if (layers[p] > 0) {
            const bool isLining = count[static_cast<std::size_t>(garment.pieces[p]->file)] == 2;
            usual[p] = isLining ? worded("Lining") : worded("Layer %1", {figure(layers[p] + 1)});
        }
    }
    return usual;
}

std::vector<PieceSettings> usualSettings(const Garment& garment) {
    std::vector<PieceSettings> settings(garment.pieces.size());
    const std::vector<Wording> materials = usualMaterials(garment);
    for (std::size_t p = 0; p < settings.size(); ++p) {
        settings[p].material = materials[p];
    }
    return settings;
}

MaterialList materialsInUse(MaterialList known, const std::vector<std::string>& used,
                            const Fabric& own) {
    std::erase_if(known, [&](const Material& material) {
        return material.fabric == own && std::ranges::find(used, material.name) == used.end();
    });
    for (const std::string& name : used) {
        if (!name.empty() && !findMaterial(name, known)) {
            known.push_back({name, own});
        }
    }
    return known;
}

}  // namespace toile
