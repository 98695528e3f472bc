// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/internal_line_edits.h"

#include <utility>

#include "core/garment/file_space.h"
#include "core/pattern/mirrored_edit.h"

namespace toile::app {

LineSettings withInternalLine(LineSettings lines, const Garment& garment, ClothPoints points,
                              bool closed) {
    InternalLine& line = lines.internalLines.emplace_back();
    line.points = inFileSpace(std::move(points), garment);
    line.closed = closed && line.points.size() > 2;
    return lines;
}

LineSettings withoutInternalLine(LineSettings lines, std::size_t index) {
    if (index < lines.internalLines.size()) {
        lines.internalLines.erase(lines.internalLines.begin() + static_cast<std::ptrdiff_t>(index));
    }
    return lines;
}

LineSettings withInternalPointMoved(LineSettings lines, const Garment& garment, std::size_t index,
                                    std::size_t point, const Eigen::Vector3d& to) {
    if (index < lines.internalLines.size() && point < lines.internalLines[index].points.size()) {
        lines.internalLines[index].points[point] = inFileSpace(to, {}, garment);
    }
    return lines;
}

std::optional<ClothPoints> mirroredInternalLine(const Garment& garment, const PieceResults& results,
                                                const Symmetry& symmetry, const ClothPoints& points,
                                                bool closed) {
    UserCut cut;
    cut.kind = closed ? UserCut::Kind::Loop : UserCut::Kind::Path;
    cut.points = points;
    if (points.size() == 1) {
        cut.points.push_back(points.front());  // a way of no length
    }
    auto image = mirroredCut(garment, results, symmetry, cut);
    if (!image) {
        return std::nullopt;
    }
    image->points.resize(points.size());
    return std::move(image->points);
}

}  // namespace toile::app
