// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/tables/report_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/flatten/base/piece_result.h"
#include "core/formats/json.h"
#include "core/geometry/line.h"
#include "core/geometry/polygon.h"
#include "core/pattern/piece_marks.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

constexpr double kSquareMillimetresPerSquareCentimetre = 100;

std::string percentText(const std::optional<double>& fraction) {
    return fraction ? fixed(100 * *fraction, 2) : "-";
}

std::string lineLengthText(const Points2& line) {
    return line.rows() > 2 ? fixed(geometry::Line::closed(line).length(), 2) : "-";
}

std::vector<std::string> pieceRow(const PatternPiece& piece, const PieceResult* result) {
    std::vector<std::string> row{piece.name, cuttingNote(piece, {}, piece.cutAs), piece.material};
    row[1] = row[1].empty() ? "cut 1" : row[1];
    row.insert(row.end(), {fixed(std::abs(geometry::signedAreaOf(edgeOf(piece))) /
                                     kSquareMillimetresPerSquareCentimetre,
                                 1),
                           lineLengthText(piece.outline), lineLengthText(piece.cuttingLine),
                           std::to_string(piece.notches.size())});
    const auto& quality = result ? result->quality : std::nullopt;
    row.insert(row.end(), {quality ? percentText(quality->strainMin) : "-",
                           quality ? percentText(quality->strainMax) : "-",
                           quality ? percentText(quality->strainMeanAbs) : "-"});
    return row;
}

std::vector<std::string> stationRow(const std::string& seam, const SeamWalk& walk, std::size_t k,
                                    const std::vector<Notch>& notches) {
    const WalkStation& at = walk.stations[k];
    std::string mark;
    if (at.notch >= 0) {
        const Notch& notch = notches[static_cast<std::size_t>(at.notch)];
        mark = std::string(wordOf(kNotchReasonWords, notch.reason)) +
               (notch.count > 1 ? ", double" : "");
    }
    std::vector<std::string> row{k == 0 ? seam : "", std::string(stationWord(walk, k)), mark};
    if (k == 0) {
        row.insert(row.end(), 4, "");
    } else {
        row.insert(row.end(), {fixed(at.left, 2), fixed(at.right, 2), fixed(at.ease, 2),
                               fixed(at.error(), 6)});
    }
    row.push_back(at.kink ? fixed(*at.kink * 180 / std::numbers::pi, 1) : "");
    return row;
}

/// Quotes a cell if the format requires it. A leading tab turns a spreadsheet formula into text.
/// Numbers are unchanged.
std::string csvCell(const std::string& text) {
    std::string cell = cleanText(text);
    const bool isNumber =
        !cell.empty() && cell.find_first_not_of("+-.0123456789eE") == std::string::npos;
    if (!cell.empty() && !isNumber && std::string_view("=+-@").find(cell[0]) != std::string::npos &&
        cell != "-") {
        cell.insert(cell.begin(), '\t');
    }
    if (cell.find_first_of(",\"\t") == std::string::npos) {
        return cell;
    }
    std::string quoted = "\"";
    for (const char c : cell) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

}  // namespace

std::string changeWords(const std::vector<LengthChange>& changes) {
    std::string words;
    for (const LengthChange& change : changes) {
        words += (words.empty() ? "" : ", ") + std::string(name(change.cause)) +
                 (change.millimetres > 0 ? " +" : " ") + fixed(change.millimetres, 2) + " mm";
    }
    return words;
}

std::vector<MeasuredSeam> seamsByError(const Garment& garment, const PieceResults& results) {
    std::vector<MeasuredSeam> rows;
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind == SeamKind::Free) {
            continue;
        }
        const PieceResult& left = *results[static_cast<std::size_t>(seam.left.piece)];
        const PieceResult& right = *results[static_cast<std::size_t>(seam.right.piece)];
        if (left.flat && right.flat) {
            rows.push_back(
                {&seam, measureSeam(seam, *left.piece, *left.flat, *right.piece, *right.flat)});
        }
    }
    // Ignore rounding: equal errors stay in the order of the seams.
    const auto nanometres = [](const MeasuredSeam& row) {
        return std::round(std::abs(row.measure.errorMm) * 1e6);
    };
    std::ranges::stable_sort(rows, std::ranges::greater{}, nanometres);
    return rows;
}

ReportTable pieceTable(const Pattern& pattern, const PieceResults& results) {
    ReportTable table{"Pieces",
                      "pieces",
                      {"piece", "cut", "material", "area cm2", "seam line mm", "cutting line mm",
                       "notches", "strain % least", "most", "mean"}};
    for (std::size_t k = 0; k < pattern.pieces.size(); ++k) {
        if (pattern.pieces[k].outline.rows() > 2) {
            table.rows.push_back(
                pieceRow(pattern.pieces[k], k < results.size() ? results[k].get() : nullptr));
        }
    }
    return table;
}

ReportTable ledgerTable(const Garment& garment, const PieceResults& results) {
    ReportTable table{"Seams",
                      "seams",
                      {"seam", "kind", "3D mm", "left mm", "right mm", "difference mm", "ease %",
                       "error mm", "changed by"}};
    for (const auto& [seam, measure] : seamsByError(garment, results)) {
        table.rows.push_back({seam->name, std::string(name(seam->kind)),
                              fixed(measure.length3d[0], 2), fixed(measure.length2dLeft, 2),
                              fixed(measure.length2dRight, 2), fixed(measure.deltaMm, 2),
                              fixed(100 * measure.ease, 1), fixed(measure.errorMm, 6),
                              changeWords(changesOf(*seam, results))});
    }
    return table;
}

ReportTable edgeTable(const Pattern& pattern) {
    ReportTable table{"Free edges",
                      "edges",
                      {"piece", "edge", "length mm", "allowance mm", "usual mm", "limited by"}};
    for (const PatternPiece& piece : pattern.pieces) {
        for (const PatternSegment& segment : piece.segments) {
            if (pattern.hasAllowance && piece.cuttingLine.rows() > 0 && segment.seam > 0 &&
                segment.kind == SeamKind::Free) {
                table.rows.push_back(
                    {piece.name,
                     std::string(wordOf(kEdgeKindWords, segment.edge)) +
                         (segment.edge == segment.foundEdge
                              ? ""
                              : ", found " +
                                    std::string(wordOf(kEdgeKindWords, segment.foundEdge))),
                     fixed(segment.to - segment.from, 1), fixed(segment.allowance, 1),
                     fixed(segment.usualAllowance, 1),
                     std::string(wordOf(kAllowanceLimitWords, segment.limit))});
            }
        }
    }
    return table;
}

ReportTable walkTable(const Garment& garment, const std::vector<std::vector<Notch>>& notches,
                      const std::vector<SeamWalk>& walks) {
    ReportTable table{
        "Walk from notch to notch",
        "walk",
        {"seam", "station", "mark", "left mm", "right mm", "ease mm", "error mm", "kink °"}};
    for (const SeamWalk& walk : walks) {
        const auto seam = static_cast<std::size_t>(walk.seam);
        for (std::size_t k = 0; k < walk.stations.size(); ++k) {
            table.rows.push_back(
                stationRow(garment.seams.seams[seam].name, walk, k, notches[seam]));
        }
    }
    return table;
}

std::string writeCsv(const ReportTable& table) {
    std::string out;
    const auto add = [&out](const std::vector<std::string>& row) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            out += (k == 0 ? "" : ",") + csvCell(row[k]);
        }
        out += "\r\n";
    };
    add(table.head);
    for (const auto& row : table.rows) {
        add(row);
    }
    return out;
}

namespace {

constexpr int kWalkVersion = 1;  // increased when a field changes its meaning or is removed

Json notchJson(const Notch& notch) {
    return {{"reason", text(wordOf(kNotchReasonWords, notch.reason))},
            {"count", notch.count},
            {"share", number(notch.share)},
            {"on_left", notch.onLeft},
            {"on_right", notch.onRight},
            {"place_2d_left", number(notch.flat.left)},
            {"place_2d_right", number(notch.flat.right)}};
}

}  // namespace

std::string_view stationWord(const SeamWalk& walk, std::size_t station) {
    return station == 0 ? "start" : station + 1 == walk.stations.size() ? "end" : "notch";
}

std::string writeWalk(const Garment& garment, const std::vector<std::vector<Notch>>& notches,
                      const std::vector<SeamWalk>& walks) {
    Json json{{"version", kWalkVersion}, {"toile", text(version())}};
    double largest = 0;
    Json seams = Json::array();
    for (const SeamWalk& walk : walks) {
        const Seam& seam = garment.seams.seams[static_cast<std::size_t>(walk.seam)];
        Json stations = Json::array();
        for (std::size_t k = 0; k < walk.stations.size(); ++k) {
            const WalkStation& at = walk.stations[k];
            const Json notch = at.notch < 0
                                   ? Json(nullptr)
                                   : notchJson(notches[static_cast<std::size_t>(walk.seam)]
                                                      [static_cast<std::size_t>(at.notch)]);
            stations.push_back({{"station", text(stationWord(walk, k))},
                                {"notch", notch},
                                {"length_2d_left", number(at.left)},
                                {"length_2d_right", number(at.right)},
                                {"ease_mm", number(at.ease)},
                                {"error_mm", number(at.error())},
                                {"kink", number(at.kink)}});
        }
        largest = std::max(largest, walk.largestError());
        seams.push_back({{"name", seam.name},
                         {"kind", text(name(seam.kind))},
                         {"pieces",
                          {garment.pieces[static_cast<std::size_t>(seam.left.piece)]->name,
                           garment.pieces[static_cast<std::size_t>(seam.right.piece)]->name}},
                         {"stations", std::move(stations)}});
    }
    json["largest_error_mm"] = number(largest);
    json["seams"] = std::move(seams);
    return jsonText(json);
}

}  // namespace toile
