// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/formats/json.h"
#include "core/formats/writers.h"
#include "core/layout/marker.h"

namespace toile {
namespace {

constexpr double kMatchTextHeight = 6;  // mm
constexpr double kMatchTextRoom = 24;   // below each pair, mm

const char* lineWord(MatchedLine line) {
    return line == MatchedLine::Cut ? "cut" : "seam";
}

Json lineMatchJson(const LineMatch& line) {
    Json json;
    json["line"] = lineWord(line.ours);
    json["file_line"] = lineWord(line.theirs);
    json["mirrored"] = line.fit.mirrored;
    json["mean_distance"] = number(line.fit.mean);
    json["max_distance"] = number(line.fit.farthest);
    json["length"] = number(line.lengthOurs);
    json["file_length"] = number(line.lengthTheirs);
    json["area"] = number(line.areaOurs);
    json["file_area"] = number(line.areaTheirs);
    return json;
}

const PatternPiece& pieceOf(const Pattern& pattern, int k) {
    return pattern.pieces[static_cast<std::size_t>(k)];
}

const FilePiece& filePieceOf(const PatternFile& file, int k) {
    return file.pieces[static_cast<std::size_t>(k)];
}

Eigen::AlignedBox2d boxOfLines(const std::vector<const Points2*>& lines) {
    Eigen::AlignedBox2d box;
    for (const Points2* line : lines) {
        for (const auto& row : line->rowwise()) {
            box.extend(row.transpose());
        }
    }
    return box;
}

const Points2& ourLine(const PatternPiece& piece, const LineMatch& line) {
    return line.ours == MatchedLine::Cut ? piece.cuttingLine : piece.outline;
}

}  // namespace

std::string writePatternMatch(const Pattern& pattern, const PatternFile& file,
                              const PatternMatch& match) {
    Json json;
    json["format"] = text(file.format);
    json["unit"] = text(unitText(file.unit));
    json["unit_reason"] = textOrNull(file.unitReason);
    json["unit_in_doubt"] = file.unitInDoubt;
    json["pairs"] = Json::array();
    for (const PieceMatch& pair : match.pairs) {
        const FilePiece& other = filePieceOf(file, pair.filePiece);
        Json entry;
        entry["piece"] = text(pieceOf(pattern, pair.piece).name);
        entry["file_piece"] = text(other.name);
        entry["file_size"] = textOrNull(other.size);
        entry["paired_by"] = text(name(pair.by));
        entry["doubtful"] = pair.isDoubtful();
        entry["also_fits"] = Json::array();
        for (const int rival : pair.rivals) {
            entry["also_fits"].push_back(text(filePieceOf(file, rival).name));
        }
        entry["lines"] = Json::array();
        for (const LineMatch& line : pair.lines) {
            entry["lines"].push_back(lineMatchJson(line));
        }
        json["pairs"].push_back(std::move(entry));
    }
    json["without_partner"] = Json::array();
    for (const int piece : match.alone) {
        json["without_partner"].push_back(text(pieceOf(pattern, piece).name));
    }
    json["without_partner_in_file"] = Json::array();
    for (const int piece : match.aloneInFile) {
        json["without_partner_in_file"].push_back(text(filePieceOf(file, piece).name));
    }
    return jsonText(json);
}

Drawing drawPatternMatch(const Pattern& pattern, const PatternFile& file,
                         const PatternMatch& match) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const PieceMatch& pair : match.pairs) {
        std::vector<const Points2*> lines;
        for (const LineMatch& line : pair.lines) {
            lines.push_back(&ourLine(pieceOf(pattern, pair.piece), line));
            lines.push_back(&line.fit.laid);
        }
        Eigen::AlignedBox2d& box = boxes.emplace_back(boxOfLines(lines));
        if (!box.isEmpty()) {
            box.min().y() -= kMatchTextRoom;
        }
    }
    const Rows rows = layOutInRows(boxes);
    Drawing drawing;
    drawing.title = pattern.name;
    drawing.width = std::ceil(rows.width + 2 * kDrawingMargin);
    drawing.height = std::ceil(rows.height + 2 * kDrawingMargin);
    for (std::size_t k = 0; k < match.pairs.size(); ++k) {
        const PieceMatch& pair = match.pairs[k];
        const PatternPiece& piece = pieceOf(pattern, pair.piece);
        if (boxes[k].isEmpty()) {
            continue;
        }
        const Eigen::Vector2d offset =
            rows.offset[k] + Eigen::Vector2d(kDrawingMargin, kDrawingMargin);
        const auto moved = [&offset](const Points2& points) -> Points2 {
            return points.rowwise() + offset.transpose();
        };
        std::vector<std::string> lines{piece.name + " / " + filePieceOf(file, pair.filePiece).name};
        for (std::size_t n = 0; n < pair.lines.size(); ++n) {
            const LineMatch& line = pair.lines[n];
            const std::string ending = n == 0 ? "" : "-" + std::to_string(n + 1);
            std::string ours = "piece-" + piece.slug;
            std::string theirs = ours;
            ours.append("-ours").append(ending);
            theirs.append("-theirs").append(ending);
            drawing.paths.push_back(
                {std::move(ours), LayerKind::Cut, moved(ourLine(piece, line)), true});
            drawing.paths.push_back(
                {std::move(theirs), LayerKind::Sew, moved(line.fit.laid), true});
            lines.push_back(std::string(lineWord(line.ours)) + " line: mean " +
                            fixed(line.fit.mean, 2) + " mm, farthest " +
                            fixed(line.fit.farthest, 2) + " mm");
        }
        const Eigen::Vector2d place(boxes[k].center().x(),
                                    boxes[k].min().y() + kMatchTextRoom - kMatchTextHeight);
        drawing.texts.push_back({"piece-" + piece.slug + "-name", LayerKind::Text, place + offset,
                                 kMatchTextHeight, lines});
    }
    return drawing;
}

}  // namespace toile
