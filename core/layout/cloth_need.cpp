// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layout/cloth_need.h"

#include <map>

#include <Eigen/Geometry>

#include "core/base/text.h"

namespace toile {

std::vector<ClothNeed> clothNeeds(const LaidOutPattern& laid, const Fabric& own) {
    const Pattern& pattern = laid.pattern;
    std::map<std::string, Eigen::AlignedBox2d> boxes;
    for (const PlacedCopy& copy : laid.marker.copies) {
        const PatternPiece& piece = pattern.pieces[static_cast<std::size_t>(copy.piece)];
        const Points2 line = turnedLine(edgeOf(piece), copy.placement);
        Eigen::AlignedBox2d& box =
            boxes[findMaterial(piece.material, pattern.materials) ? piece.material : std::string()];
        for (Eigen::Index k = 0; k < line.rows(); ++k) {
            box.extend(Eigen::Vector2d(line.row(k).transpose()) + copy.placement.offset);
        }
    }
    std::vector<ClothNeed> needs;
    needs.reserve(boxes.size());
    for (const auto& [material, box] : boxes) {
        needs.push_back({material, box.sizes().y(), box.sizes().x(),
                         fabricOf(material, pattern.materials, own).width});
    }
    return needs;
}

std::string sentence(const ClothNeed& need) {
    const std::string of = need.material.empty() ? "" : " (" + need.material + ')';
    return need.fits() ? fixed(need.length, 0) + " mm of cloth" + of + ' ' + fixed(need.width, 0) +
                             " mm wide, as the pieces lie"
                       : "the pieces" + of + " lie " + fixed(need.across, 0) +
                             " mm wide, wider than the cloth: " + fixed(need.width, 0) + " mm";
}

}  // namespace toile
