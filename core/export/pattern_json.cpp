// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/json.h"
#include "core/pattern/darts.h"
#include "core/pattern/piece_allowance.h"
#include "core/quality/closed_line.h"

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
    return {{"seam", segment.seam > 0 ? Json(segment.seam) : Json(nullptr)},
            {"from", number(segment.from)},
            {"to", number(segment.to)},
            {"fold", segment.isFold},
            {"allowance", number(segment.allowance)},
            {"corner", text(wordOf(kCornerRuleWords, corner))}};
}

Json dartJson(const PieceDart& dart) {
    return {{"seam", dart.seam},
            {"intake", number(dart.intake)},
            {"angle", number(dart.angle)},
            {"leg", number(dart.leg)},
            {"laid_over", text(dart.lay == DartLay::First ? "first" : "second")}};
}

}  // namespace

void addPatternJson(Json& json, const Pattern& pattern, const PatternPiece& piece) {
    if (pattern.hasAllowance && piece.cuttingLine.rows() > 0) {
        json["cutting_line_length"] = number(ClosedLine(piece.cuttingLine).length());
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
    if (pattern.hasNotches) {
        json["notches"] = Json::array();
        for (const PieceNotch& notch : piece.notches) {
            json["notches"].push_back(notchJson(pattern, notch));
        }
    }
}

}  // namespace toile
