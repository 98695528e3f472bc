// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/hide_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/formats/dxf/dxf_curve.h"
#include "core/formats/dxf/dxf_document.h"
#include "core/formats/dxf/dxf_piece.h"
#include "core/formats/svg/svg_reader.h"
#include "core/geometry/polygon.h"
#include "core/nest/item_rings.h"

namespace toile {
namespace {

constexpr const char* kNoHide = translatable("it has no closed line that could be a hide");
constexpr const char* kZoneOutside =
    translatable("a closed line that starts outside the hide is left out (layer \"%1\")");
constexpr const char* kHideUnit = translatable("its unit is assumed to be %1: %2");
constexpr double kHideEndsNear = 0.01;  // mm, joins ends of lines
constexpr double kMinHideArea = 1;      // mm2

/// Lines by layer, in the order of the file's layers.
using LinesOfLayers = std::vector<std::pair<std::string, std::vector<FileLine>>>;

void addHideLine(LinesOfLayers& layers, std::string_view layer, FileLine line) {
    auto found = std::ranges::find(layers, layer, &LinesOfLayers::value_type::first);
    if (found == layers.end()) {
        layers.emplace_back(std::string(layer), std::vector<FileLine>{});
        found = std::prev(layers.end());
    }
    found->second.push_back(std::move(line));
}

Result<LinesOfLayers> readDxfLines(std::string_view bytes, std::vector<Wording>& notes) {
    const auto document = readDxfDocument(bytes);
    if (!document) {
        return document.error();
    }
    notes = document->notes;
    if (auto tooMany = refusalOfCurves(*document, 1)) {
        return *std::move(tooMany);
    }
    DxfBlockInserter inserter(*document);
    std::vector<DxfEntity> entities = inserter.replaced(document->entities);
    const auto extentOf = [&entities] {
        Eigen::AlignedBox2d box;
        for (const DxfEntity& entity : entities) {
            if (const auto line = dxfCurve(entity, 1)) {
                box.extend(geometry::boxAround(line->points));
            }
        }
        return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
    };
    double extent = extentOf();
    if (extent == 0) {  // the drawing is in blocks without an INSERT
        for (const DxfBlock& block : document->blocks) {
            const auto more = inserter.replaced(block.entities);
            entities.insert(entities.end(), more.begin(), more.end());
        }
        extent = extentOf();
    }
    const DxfUnit unit = dxfUnit(*document, "", extent);
    if (unit.inDoubt) {
        notes.push_back(worded(kHideUnit, {std::string(symbol(unit.unit)), unit.reason}));
    }
    const double millimetres = millimetresPer(unit.unit);
    if (auto tooMany = refusalOfCurves(*document, millimetres)) {
        return *std::move(tooMany);
    }
    LinesOfLayers layers;
    DxfLeftOut left;
    for (const DxfEntity& entity : entities) {
        if (auto line = dxfCurve(entity, millimetres)) {
            line->points *= millimetres;
            addHideLine(layers, entity.layer, std::move(*line));
        } else if (entity.kind != "TEXT" && entity.kind != "MTEXT") {
            left.add(DxfLeftOut::KindNotRead, entity);
        }
    }
    left.tell(notes);
    return layers;
}

Result<LinesOfLayers> readSvgLines(std::string_view bytes) {
    const auto svg = readSvg(bytes);
    if (!svg) {
        return svg.error();
    }
    LinesOfLayers layers;
    for (const SvgLine& line : svg->lines) {
        if (line.text.empty()) {
            addHideLine(layers, line.layer, {line.points, line.closed});
        }
    }
    return layers;
}

struct HideLine {
    geometry::Polygon points;
    std::string layer;
    double area = 0;
};

/// Closed lines, largest first.
std::vector<HideLine> closedLines(const LinesOfLayers& layers, std::vector<Wording>& notes) {
    std::vector<HideLine> closed;
    long long open = 0;
    for (const auto& [layer, lines] : layers) {
        for (const FileLine& line : joinedLines(lines, kHideEndsNear, kHideEndsNear)) {
            Eigen::Index count = line.points.rows();
            while (count > 3 && line.points.row(count - 1) == line.points.row(0)) {
                --count;
            }
            if (!line.closed || count < 3) {
                open += 1;
                continue;
            }
            const auto points = geometry::antiClockwise(line.points.topRows(count));
            const double area = geometry::signedAreaOf(points);
            if (area > kMinHideArea) {
                closed.push_back({points, layer, area});
            }
        }
    }
    if (open > 0) {
        notes.push_back(
            worded("left out because they are not closed: %1", {countWording(open, "line")}));
    }
    std::ranges::stable_sort(closed, std::greater{}, &HideLine::area);
    return closed;
}

}  // namespace

int gradeOfLayer(std::string_view layer) {
    std::string small(layer);
    std::ranges::transform(small, small.begin(), lowered);
    std::size_t at = small.find("grade");
    if (at == std::string::npos) {
        return 0;
    }
    at = small.find_first_of("0123456789", at);
    int grade = 0;
    if (at != std::string::npos) {
        std::from_chars(small.data() + at, small.data() + small.size(), grade);
    }
    return grade;
}

Result<HideFile> readHide(std::string_view bytes, PatternFileKind kind) {
    HideFile file;
    const auto layers =
        kind == PatternFileKind::Dxf ? readDxfLines(bytes, file.notes) : readSvgLines(bytes);
    if (!layers) {
        return layers.error();
    }
    const std::vector<HideLine> closed = closedLines(*layers, file.notes);
    if (closed.empty()) {
        return Error{ErrorCode::NoGeometry, {}, worded(kNoHide)};
    }
    for (const HideLine& line : closed) {
        if (const auto usable = nest::usableRings(Subject{}, {line.points}); !usable) {
            return usable.error();
        }
    }
    const geometry::Polygon& edge = closed.front().points;
    const Eigen::RowVector2d corner = edge.colwise().minCoeff();
    file.hide.outline = edge.rowwise() - corner;
    for (std::size_t k = 1; k < closed.size(); ++k) {
        const HideLine& line = closed[k];
        if (geometry::isInside(edge, line.points.row(0).transpose())) {
            file.hide.zones.push_back({line.points.rowwise() - corner, gradeOfLayer(line.layer)});
        } else {
            file.notes.push_back(worded(kZoneOutside, {readableName(line.layer)}));
        }
    }
    shortenNotes(file.notes);
    return file;
}

Result<HideFile> readHide(const std::filesystem::path& path) {
    const auto kind = patternFileKind(path);
    if (!kind || kind == PatternFileKind::GarmentCode) {
        return Error{ErrorCode::UnknownFormat, Subject::file(path.string()),
                     "hides must be .dxf or .svg files"};
    }
    const Result<std::string> bytes = readFile(path);
    if (!bytes) {
        return bytes.error();
    }
    auto file = readHide(*bytes, *kind);
    if (!file) {
        Error error = file.error();
        error.subject = Subject::file(path.string());
        return error;
    }
    file->hide.name = path.stem().string();
    return file;
}

}  // namespace toile
