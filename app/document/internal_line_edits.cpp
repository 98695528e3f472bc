// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/internal_line_edits.h"

#include <algorithm>
#include <utility>

#include "core/assemble/file_space.h"
#include "core/pattern/mirrored_edit.h"

namespace toile::app {

LineSettings withInternalLine(LineSettings lines, const Garment& garment, std::string name,
                              ClothPoints points, bool closed) {
    InternalLine& line = lines.internalLines.emplace_back();
    line.name = std::move(name);
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
        cut.points.push_back(points.front());  // a path of no length
    }
    auto image = mirroredCut(garment, results, symmetry, cut);
    if (!image) {
        return std::nullopt;
    }
    image->points.resize(points.size());
    return std::move(image->points);
}

std::optional<std::size_t> imageOfInternalLine(const LineSettings& lines, const Garment& garment,
                                               const PieceResults& results,
                                               const Symmetry& symmetry, std::size_t index) {
    const InternalLine& line = lines.internalLines[index];
    const auto image = mirroredInternalLine(garment, results, symmetry,
                                            inPieceSpace(line.points, garment), line.closed);
    for (std::size_t k = 0; image && k < lines.internalLines.size(); ++k) {
        const InternalLine& other = lines.internalLines[k];
        if (k == index || other.closed != line.closed ||
            other.points.size() != line.points.size()) {
            continue;
        }
        const ClothPoints points = inPieceSpace(other.points, garment);
        if (std::ranges::equal(points, *image, [](const auto& a, const auto& b) {
                return (a - b).norm() < kSameImage;
            })) {
            return k;
        }
    }
    return std::nullopt;
}

LineSettings withInternalLineAsImage(LineSettings lines, const Garment& garment,
                                     const PieceResults& results, const Symmetry& symmetry,
                                     std::size_t of, std::size_t image) {
    const InternalLine& line = lines.internalLines[of];
    if (auto points = mirroredInternalLine(garment, results, symmetry,
                                           inPieceSpace(line.points, garment), line.closed)) {
        lines.internalLines[image].points = inFileSpace(std::move(*points), garment);
    }
    return lines;
}

}  // namespace toile::app
