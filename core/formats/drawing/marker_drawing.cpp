// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/drawing/marker_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/formats/formats.h"
#include "core/pattern/label.h"

namespace toile {
namespace {

constexpr double kClothTextHeight = 8;  // mm
constexpr double kClothTextGap = 3;     // mm, above the cloth

Points2 onPage(const geometry::Polygon& line) {
    return line.array() + kDrawingMargin;
}

}  // namespace

DrawnMarker drawMarker(const Pattern& pattern, const ClothMarker& marker,
                       const MarkerSettings& settings, const std::vector<std::string>& title,
                       DrawingWords words) {
    DrawnMarker drawn;
    drawn.laid.pattern = pattern;
    for (PatternPiece& piece : drawn.laid.pattern.pieces) {
        piece.quantity = 1;
        piece.mirroredPair = piece.mirroredPair && settings.isFolded;
    }
    drawn.laid.marker = pageOf(marker);
    words.mirrored.clear();
    drawn.drawing = draw(drawn.laid.pattern, drawn.laid.marker, words);
    Drawing& drawing = drawn.drawing;
    // The user may place a copy outside the cloth.
    for (const LaidCopy& copy : marker.copies) {
        const double top = laidOutline(pattern, copy).col(1).maxCoeff();
        drawing.height = std::max(drawing.height, std::ceil(top + 2 * kDrawingMargin));
    }
    for (std::size_t k = 0; k < marker.parts.size(); ++k) {
        const ClothPart& part = marker.parts[k];
        const std::string id = "cloth-" + std::to_string(k + 1);
        drawing.paths.push_back({id, LayerKind::Marks, onPage(part.outline)});
        for (std::size_t z = 0; z < part.zones.size(); ++z) {
            drawing.paths.push_back({id + "-zone-" + std::to_string(z + 1), LayerKind::Marks,
                                     onPage(part.zones[z].outline)});
        }
    }
    if (settings.isFolded && marker.length > 0) {
        geometry::Polygon fold(2, 2);
        fold << 0, 0, marker.length, 0;
        drawing.paths.push_back({"cloth-fold", LayerKind::Marks, onPage(fold), false});
    }
    if (!title.empty()) {
        const Eigen::Vector2d size = textExtent(title, kClothTextHeight);
        const double below = size.y() - 0.5 * kClothTextHeight;  // of the first line's middle
        const Eigen::Vector2d at(kDrawingMargin + 0.5 * size.x(),
                                 kDrawingMargin + marker.width + kClothTextGap + below);
        drawing.texts.push_back({"cloth-text", LayerKind::Text, at, kClothTextHeight, title});
        drawing.width = std::max(drawing.width, std::ceil(2 * kDrawingMargin + size.x()));
        drawing.height =
            std::max(drawing.height, std::ceil(at.y() + kClothTextHeight + kClothTextGap));
    }
    return drawn;
}

bool holdsMarkers(const std::filesystem::path& path) {
    const Format* format = formatOf(path);
    return format && format->write && (format->layers || format->id == FormatId::Png);
}

}  // namespace toile
