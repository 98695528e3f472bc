// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/wording.h"
#include "core/formats/read_backs.h"
#include "core/formats/svg/svg_style.h"

namespace toile {
namespace {

/// "it is 3.0000 mm instead of 2.0000 mm".
std::string insteadOf(double is, double should) {
    return "it is " + fixed(is, 4) + " mm instead of " + fixed(should, 4) + " mm";
}

Result<void> comparePage(const ReadSvg& svg, const Drawing& drawing) {
    for (const auto& [is, should] :
         {std::pair(svg.width, drawing.width), std::pair(svg.height, drawing.height)}) {
        if (!(std::abs(is - should) <= kReadBackCoordinates)) {
            return notReadBack("the page", insteadOf(is, should));
        }
    }
    return {};
}

/// comparedWithDrawing finds lines by id, so the layers are compared here.
Result<void> compareLayers(const ReadDrawing& read, const Drawing& drawing) {
    std::map<std::string_view, LayerKind> layers;
    for (const DrawnPath& path : drawing.paths) {
        layers.emplace(path.id, path.layer);
    }
    for (const ReadLine& line : read.lines) {
        const auto found = layers.find(line.id);
        if (found == layers.end() || found->second != line.layer) {
            return notReadBack(line.id, "it is on another layer");
        }
    }
    return {};
}

/// @return  the distance of the lines, mm
Result<double> compareSeam(const SvgLine& line, const DrawnEdge& edge) {
    const SvgSeam& seam = *line.seam;
    if (seam.pair != edge.pair || seam.name != cleanText(edge.seam)) {
        return notReadBack(edge.id, "it is another seam");
    }
    if (!(std::abs(seam.length3d - edge.length3d) <= kReadBackLengths)) {
        return notReadBack(edge.id, insteadOf(seam.length3d, edge.length3d));
    }
    const double distance = distanceBetween(
        {.id = line.id, .points = line.points, .closed = line.closed},
        {.id = edge.id, .layer = LayerKind::Sew, .points = edge.points, .closed = false});
    if (line.closed || !(distance <= kReadBackCoordinates)) {
        return notReadBack(edge.id, "it is in another place");
    }
    return distance;
}

/// @return  the largest distance, mm
Result<double> compareSeams(const ReadSvg& svg, const std::vector<DrawnEdge>& edges) {
    std::map<std::string_view, const SvgLine*> found;
    for (const SvgLine& line : svg.lines) {
        if (line.seam && !found.emplace(line.id, &line).second) {
            return notReadBack(line.id, "it occurs twice");
        }
    }
    double largest = 0;
    for (const DrawnEdge& edge : edges) {
        const auto at = found.find(edge.id);
        if (at == found.end()) {
            return notReadBack(edge.id, "it is missing");
        }
        const auto distance = compareSeam(*at->second, edge);
        if (!distance) {
            return distance.error();
        }
        largest = std::max(largest, *distance);
    }
    if (found.size() != edges.size()) {
        return notReadBack("seams", std::to_string(found.size()) + " sides instead of " +
                                        std::to_string(edges.size()));
    }
    return largest;
}

}  // namespace

ReadDrawing drawingOf(const ReadSvg& svg) {
    ReadDrawing read;
    std::set<std::string_view> pieces;
    for (const SvgLine& line : svg.lines) {
        if (!line.text.empty() || line.seam) {
            continue;
        }
        if (!line.piece.empty()) {
            pieces.insert(line.piece);
        }
        read.lines.push_back(
            {.layer = layerNamed(line.layer, &LayerNames::svg).value_or(LayerKind::Cut),
             .id = line.id,
             .points = line.points,
             .closed = line.closed});
    }
    read.pieces = static_cast<int>(pieces.size());
    return read;
}

Result<ReadBack> readBackSvg(std::string_view bytes, const Drawing& drawing,
                             const SvgOptions& options) {
    const auto svg = readSvg(bytes);
    if (!svg) {
        return notReadBack(drawing.title, sentence(svg.error()));
    }
    const ReadDrawing read = drawingOf(*svg);
    for (const auto& compared : {comparePage(*svg, drawing), compareLayers(read, drawing)}) {
        if (!compared) {
            return compared.error();
        }
    }
    auto found = comparedWithDrawing(read, drawing, {kLayerKinds.begin(), kLayerKinds.end()});
    if (!found) {
        return found;
    }
    const bool hasSeams = svgStyle(options).hasSeams;
    const auto farthest = compareSeams(*svg, hasSeams ? drawing.edges : std::vector<DrawnEdge>());
    if (!farthest) {
        return farthest.error();
    }
    found->largest = std::max(found->largest, *farthest);
    return found;
}

}  // namespace toile
