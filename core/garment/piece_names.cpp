// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/piece_names.h"

namespace toile {
namespace {

constexpr const char* kPanel = "panel";

std::string nameOf(const std::vector<int>& ofFace, const std::vector<std::string>& names,
                   int face) {
    return ofFace.empty() || ofFace[face] < 0 ? std::string() : names[ofFace[face]];
}

}  // namespace

PieceNames::PieceNames(const PolygonSoup& soup, SplitMode mode) : soup_(soup), mode_(mode) {}

std::string PieceNames::inFile(int face) const {
    std::string name;
    if (mode_ == SplitMode::Materials) {
        name = nameOf(soup_.faceMaterial, soup_.materials, face);
    } else if (mode_ == SplitMode::Groups) {
        name = nameOf(soup_.faceGroup, soup_.groups, face);
    } else if (mode_ == SplitMode::Uv) {
        // One name over the whole garment says nothing about its panels.
        if (soup_.objects.size() > 1) {
            name = nameOf(soup_.faceObject, soup_.objects, face);
        } else if (soup_.groups.size() > 1) {
            name = nameOf(soup_.faceGroup, soup_.groups, face);
        }
        return name.empty() ? kPanel : name;
    }
    if (name.empty()) {
        name = nameOf(soup_.faceObject, soup_.objects, face);
    }
    if (name.empty()) {
        name = nameOf(soup_.faceGroup, soup_.groups, face);
    }
    return name.empty() ? "piece" : name;
}

std::string PieceNames::unique(const std::string& wanted) {
    const bool isGeneric = wanted == kPanel;  // "panel 1" from the first on: there will be more
    std::string name = isGeneric ? std::string(kPanel) + " 1" : wanted;
    int& next = nextNumber_.try_emplace(wanted, 2).first->second;
    while (!taken_.insert(name).second) {
        name = wanted + " " + std::to_string(next++);
    }
    return name;
}

}  // namespace toile
