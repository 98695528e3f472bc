// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/dxf_read_back.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/export/apparel_read_back.h"
#include "core/reading/dxf_drawing.h"

namespace toile {
namespace {

struct NamedKind {
    std::string_view name;
    LayerKind kind;
};

constexpr std::array kNamedLayers{
    NamedKind{"CUT", LayerKind::Cut},         NamedKind{"SEW", LayerKind::Sew},
    NamedKind{"NOTCHES", LayerKind::Notches}, NamedKind{"INTERNAL", LayerKind::Internal},
    NamedKind{"MARKS", LayerKind::Marks},     NamedKind{"GRAIN", LayerKind::Grain},
    NamedKind{"CHECK", LayerKind::Check}};

/// The lines of the plain profile have no names: those of a layer are in the drawing's order.
Result<ReadBack> readPlainBack(const DxfDrawing& read, const Drawing& drawing) {
    ReadDrawing lines;
    std::map<LayerKind, std::vector<const DxfLine*>> byLayer;
    for (const DxfLine& line : read.page.polylines) {
        const auto layer = std::ranges::find(kNamedLayers, line.layer, &NamedKind::name);
        if (layer == kNamedLayers.end()) {
            return notReadBack({}, "layer \"" + std::string(line.layer) + "\"");
        }
        lines.lines.push_back({layer->kind, {}, line.points, line.closed});
        byLayer[layer->kind].push_back(&line);
    }
    std::map<LayerKind, std::size_t> next;
    std::size_t holes = 0, words = 0;
    for (const DrawnPath& path : drawing.paths) {
        const std::size_t at = next[path.layer]++;
        if (at < byLayer[path.layer].size() &&
            !hasEveryPoint(byLayer[path.layer][at]->points, path, {})) {
            return notReadBack({}, path.id + ": points are missing or elsewhere");
        }
        holes += path.layer == LayerKind::Cut ? 1 : 0;
    }
    holes -= std::min(holes, drawing.blocks.size());
    lines.pieces = static_cast<int>(byLayer[LayerKind::Cut].size()) - static_cast<int>(holes);
    for (const DrawnText& text : drawing.texts) {
        words += text.lines.size();
    }
    if (read.page.texts.size() != words) {
        return notReadBack({},
                           countWording(static_cast<long long>(read.page.texts.size()), "text") +
                               " instead of " + std::to_string(words));
    }
    return comparedWithDrawing(
        lines, drawing,
        {LayerKind::Cut, LayerKind::Sew, LayerKind::Notches, LayerKind::Internal, LayerKind::Marks,
         LayerKind::Grain, LayerKind::Check});
}

/// Of a grade table with one size.
bool isRuleTable(std::string_view bytes, LengthUnit unit) {
    const std::string units =
        std::string("\r\nUnits: ") + (unit == LengthUnit::Inch ? "ENGLISH" : "METRIC") + "\r\n";
    return bytes.find(units) != std::string_view::npos &&
           bytes.find("\r\nNumber of Sizes: 1\r\n") != std::string_view::npos &&
           bytes.ends_with("\r\nEnd\r\n");
}

}  // namespace

Result<ReadBack> readDxfBack(const ExportedFiles& files, const ExportSource& source) {
    if (files.empty()) {
        return notReadBack({}, "no file");
    }
    const auto document = readDxfDocument(files.front().bytes);
    if (!document) {
        return notReadBack({}, document.error().detail);
    }
    if (!document->hasEnd) {
        return notReadBack({}, "it has no end");
    }
    const DxfOptions& options = source.options().dxf;
    const double unit = millimetresPer(options.unit);
    if (options.profile == DxfProfile::Plain) {
        if (statedUnit(*document) != unit) {
            return notReadBack({}, "its unit is another");
        }
        return readPlainBack(dxfDrawing(*document, unit), source.drawing());
    }
    for (const ExportedFile& file : files) {
        if (file.beside == ".rul" && !isRuleTable(file.bytes, options.unit)) {
            return notReadBack({}, "the rule table is none");
        }
    }
    return readApparelBack(dxfDrawing(*document, unit), source);
}

}  // namespace toile
