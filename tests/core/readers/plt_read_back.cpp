// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/plt_read_back.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "core/formats/writers.h"

namespace toile {
namespace {

/// As the drawing lies.
Points2 turnedBack(const Points2& line, const Drawing& drawing, const PltOptions& options) {
    if (!options.turned) {
        return line;
    }
    Points2 back(line.rows(), 2);
    back.col(0) = line.col(1);
    back.col(1) = drawing.height - line.col(0).array();
    return back;
}

/// Pieces whose line is there, by the order in which lines are written: which line lies in which
/// other says nothing where pieces lie on each other.
int countPieces(const std::vector<ReadLine>& lines, const Drawing& drawing) {
    std::set<std::string_view> cut;
    for (const ReadLine& line : lines) {
        if (line.layer == LayerKind::Cut && line.closed) {
            cut.insert(line.id);
        }
    }
    return static_cast<int>(std::ranges::count_if(drawing.blocks, [&](const DrawnBlock& block) {
        return cut.contains(drawing.paths[block.path].id);
    }));
}

/// @return  false where a line is off the page by more than the writing of places allows
bool isOnPage(const std::vector<PltLine>& plot, const Drawing& drawing, const PltOptions& options) {
    return std::ranges::all_of(plot, [&](const PltLine& line) {
        const Points2 points = turnedBack(line.points, drawing, options);
        return points.minCoeff() >= -kReadBackCoordinates &&
               points.col(0).maxCoeff() <= drawing.width + kReadBackCoordinates &&
               points.col(1).maxCoeff() <= drawing.height + kReadBackCoordinates;
    });
}

}  // namespace

ReadDrawing drawingOf(const std::vector<PltLine>& plot, const Drawing& drawing,
                      const PltOptions& options) {
    std::vector<const DrawnPath*> inner, cuts;
    for (const DrawnPath& path : drawing.paths) {
        (path.layer == LayerKind::Cut ? cuts : inner).push_back(&path);
    }
    std::ranges::reverse(cuts);
    ReadDrawing read;
    std::size_t nextInner = 0, nextCut = 0;
    for (const PltLine& line : plot) {
        constexpr int kCut = 1, kInner = 2;
        if (line.pen != kCut && line.pen != kInner) {
            continue;
        }
        const bool isCut = line.pen == kCut;
        const std::vector<const DrawnPath*>& meant = isCut ? cuts : inner;
        std::size_t& next = isCut ? nextCut : nextInner;
        ReadLine& found = read.lines.emplace_back();
        found.layer = isCut ? LayerKind::Cut : LayerKind::Internal;
        if (next < meant.size()) {
            found.layer = meant[next]->layer;
            found.id = meant[next]->id;
            ++next;
        }
        found.points = turnedBack(line.points, drawing, options);
        found.closed = line.closed;
    }
    read.pieces = countPieces(read.lines, drawing);
    return read;
}

Result<ReadBack> readBackPlt(std::string_view bytes, const Drawing& drawing,
                             const PltOptions& options) {
    const auto plot = readPlt(bytes);
    if (!plot) {
        return notReadBack(drawing.title, sentence(plot.error()));
    }
    if (!isOnPage(*plot, drawing, options)) {
        return notReadBack("the page", "a line leaves it");
    }
    const ReadDrawing read = drawingOf(*plot, drawing, options);
    return comparedWithDrawing(read, drawing, {kLayerKinds.begin(), kLayerKinds.end()},
                               1 / kPlotterUnits);
}

}  // namespace toile
