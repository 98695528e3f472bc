// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/json.h"
#include "core/geometry/line.h"
#include "core/pattern/darts.h"
#include "core/pattern/piece_allowance.h"

namespace toile {
namespace {

Json notchJson(const Pattern& pattern, const PieceNotch& notch) {
    return {{"seam", notch.seam},
            {"share", number(notch.share)},
            {"hole", notch.hole < 0 ? Json(nullptr) : Json(notch.hole + 1)},
            {"at", number(notch.at)},
            {"count", notch.count},
            {"form", text(wordOf(kNotchFormWords, pattern.notchForm))},
            {"reason", text(wordOf(kNotchReasonWords, notch.reason))}};
}

Json segmentJson(const PatternSegment& segment, CornerRule corner) {
    Json json{{"seam", segment.seam > 0 ? Json(segment.seam) : Json(nullptr)},
              {"from", number(segment.from)},
              {"to", number(segment.to)},
              {"fold", segment.isFold},
              {"allowance", number(segment.allowance)},
              {"corner", text(wordOf(kCornerRuleWords, corner))}};
    if (segment.extension > 0) {
        json["extension"] = number(segment.extension);
    }
    return json;
}

Json dartJson(const PieceDart& dart) {
    return {{"seam", dart.seam},
            {"intake", number(dart.intake)},
            {"intake_typed", dart.isTyped},
            {"angle", number(dart.angle)},
            {"leg", number(dart.leg)},
            {"laid_over", text(dart.lay == DartLay::First ? "first" : "second")}};
}

/// A strip as cut; only its name if it has no room.
Json facingJson(const PatternPiece& piece, const PatternPiece& strip) {
    Json json{{"name", strip.name}, {"piece", piece.name}, {"drawn", strip.outline.rows() > 0}};
    if (strip.outline.rows() > 0) {
        json["perimeter_2d"] = number(geometry::Line::closed(strip.outline).length());
        json["quantity"] = strip.quantity;
        json["mirrored_pair"] = strip.mirroredPair;
        if (strip.cuttingLine.rows() > 0) {
            json["cutting_line_length"] =
                number(geometry::Line::closed(strip.cuttingLine).length());
        }
    }
    return json;
}

Json internalJson(const PieceInternal& internal) {
    Json points = Json::array();
    for (const auto& point : internal.points.rowwise()) {
        points.push_back({number(point.x()), number(point.y())});
    }
    return {{"name", text(internal.name)},
            {"closed", internal.closed},
            {"length", number(internal.length)},
            {"points", std::move(points)}};
}

}  // namespace

Json facingsJson(const Pattern& pattern) {
    Json facings = Json::array();
    const std::size_t first = pattern.pieces.size() - pattern.facings.size();
    for (std::size_t k = 0; k < pattern.facings.size(); ++k) {
        const PatternPiece& piece = pattern.pieces[pattern.facings[k].piece];
        facings.push_back(facingJson(piece, pattern.pieces[first + k]));
    }
    return facings;
}

void addPatternJson(Json& json, const Pattern& pattern, const PatternPiece& piece) {
    if (pattern.hasAllowance && piece.cuttingLine.rows() > 0) {
        json["cutting_line_length"] = number(geometry::Line::closed(piece.cuttingLine).length());
        json["segments"] = Json::array();
        for (std::size_t k = 0; k < piece.segments.size(); ++k) {
            json["segments"].push_back(segmentJson(piece.segments[k], cornerOf(piece, k)));
        }
    }
    const std::vector<PieceDart> darts =
        pattern.hasAllowance ? findDarts(piece) : std::vector<PieceDart>();
    if (!darts.empty()) {
        json["darts"] = Json::array();
        for (const PieceDart& dart : darts) {
            json["darts"].push_back(dartJson(dart));
        }
    }
    for (const PieceInternal& internal : piece.internals) {
        if (internal.points.rows() > 0) {
            json["internal_lines"].push_back(internalJson(internal));
        }
    }
    if (pattern.hasNotches) {
        json["notches"] = Json::array();
        for (const PieceNotch& notch : piece.notches) {
            json["notches"].push_back(notchJson(pattern, notch));
        }
    }
}

}  // namespace toile
