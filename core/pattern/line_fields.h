// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/setting.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/trueing.h"

namespace toile {

/// Descriptions of the settings of lines, for project files and forms (core/base/field_archive.h).

inline constexpr double kMaxTurns = 2;  ///< around a closed line

inline constexpr const char* kNotchFormNames[] = {TR("Slit"), TR("V"), TR("T"), TR("Castle")};
inline constexpr const char* kDartLayNames[] = {TR("Over the first leg"),
                                                TR("Over the second leg")};
inline constexpr const char* kCornerRuleNames[] = {TR("Mitred"),
                                                   TR("Square"),
                                                   TR("Right angle to previous"),
                                                   TR("Right angle to this"),
                                                   TR("Mirrored on previous"),
                                                   TR("Mirrored on this"),
                                                   TR("Stepped")};

inline constexpr const char* kEdgeKindNames[kEdgeKindCount] = {
    TR("Hem"),        TR("Cuff"),        TR("Neckline"), TR("Armhole"), TR("Waist"),
    TR("Front edge"), TR("Collar edge"), TR("Slit"),     TR("Unknown")};

/// Keys of the widths along free edges, by EdgeKind; that of hems has its own setting.
inline constexpr const char* kEdgeWidthKeys[kEdgeKindCount] = {
    "hem", "cuff", "neckline", "armhole", "waist", "frontEdge", "collarEdge", "slit", "unknown"};

inline constexpr auto kStretchFields = [](auto& at, auto& stretch) {
    at.need("line");
    at.id("line", stretch.line);
    at.field("from", stretch.from, -kMaxTurns, kMaxTurns);
    at.field("to", stretch.to, -kMaxTurns, kMaxTurns);
};

inline constexpr auto kFairingFields = [](auto& at, auto& fairing) {
    at.field(Setting{"tolerance", TR("&Tolerance"), TR("Tolerance of fair lines"),
                     TR("Maximum distance of a line from the exact outline")},
             fairing.tolerance, kMinFairTolerance, kMaxFairTolerance);
    at.field(Setting{"smoothing", TR("Smoot&hing length"), TR("Smoothing length"),
                     TR("Larger values smooth longer waves")},
             fairing.smoothing, kMinSmoothing, kMaxSmoothing);
    at.field("fixed", fairing.isFixed);
};

inline constexpr auto kSegmentFields = [](auto& at, auto& chosen) {
    at.need("place");
    at.object("place", chosen.place, kStretchFields);
    at.field(Setting{"length", TR("Len&gth"), TR("Length of a segment"),
                     TR("Length in the pattern, on both sides of a seam"), TR("3D length")},
             chosen.length, kMinSegmentLength, kMaxSegmentLength);
    at.field(Setting{"tolerance", TR("T&olerance"), TR("Tolerance of a segment"),
                     TR("Maximum distance of this segment's line from the exact outline; switches "
                        "on fair lines"),
                     TR("Default")},
             chosen.tolerance, kMinFairTolerance, kMaxFairTolerance);
    at.field(Setting{"straight", TR("Straight"), TR("Straight segment"),
                     TR("Draw the segment as a straight line; switches on fair lines")},
             chosen.straight);
    at.field(Setting{"allowance", TR("Allo&wance"), TR("Allowance of a segment"),
                     TR("Width of the cloth beyond the line"), TR("Default")},
             chosen.allowance, 0, kMaxAllowance);
    at.word(Setting{"edge", TR("&Kind of edge"), TR("Kind of a free edge"),
                    TR("What the free edge is on the worn garment; sets the usual width of its "
                       "allowance"),
                    TR("As found"), kEdgeKindNames},
            chosen.edge, kEdgeKindWords);
    at.word(Setting{"corner", TR("Corner at its &start"), TR("Corner of an allowance"),
                    TR("How the allowances meet at the start of the segment, anti-clockwise around "
                       "the piece"),
                    TR("Automatic"), kCornerRuleNames},
            chosen.corner, kCornerRuleWords);
    at.field(
        Setting{
            .key = "extension",
            .title = TR("E&xtension"),
            .name = TR("Extension of an edge"),
            .help =
                TR("Extend a free edge in parallel by this width, for a button stand or a turn-up"),
            .none = TR("none")},
        chosen.extension, kMinStrip, kMaxStrip);
};

inline constexpr auto kTurnPointFields = [](auto& at, auto& chosen) {
    at.need("line");
    at.id("line", chosen.line);
    at.field("at", chosen.at, -kMaxTurns, kMaxTurns);
    at.field("reversed", chosen.reversed);
    at.field("turns", chosen.turns);
};

inline constexpr auto kSeamEndFields = [](auto& at, auto& chosen) {
    at.need("left");
    at.object("left", chosen.seam.left, kStretchFields);
    if (at.kReads || chosen.seam.right.line) {
        at.object("right", chosen.seam.right, kStretchFields);
    }
    at.field("atEnd", chosen.atEnd);
    at.field("trued", chosen.trued);
};

inline constexpr auto kAllowanceFields = [](auto& at, auto& widths) {
    at.field(Setting{"seam", TR("Seams"), TR("Width of seam allowances"),
                     TR("Allowance along sewn edges")},
             widths.seam, 0, kMaxAllowance);
    at.field(Setting{"hem", TR("Hems"), TR("Width of hems"),
                     TR("Allowance along hems; other free edges have usual widths of their kinds")},
             widths.hem, 0, kMaxAllowance);
    for (std::size_t k = 1; k < kEdgeKindCount; ++k) {
        at.field(Setting{kEdgeWidthKeys[k], kEdgeKindNames[k], kEdgeKindNames[k],
                         TR("Allowance along free edges of this kind"), TR("Usual")},
                 widths.edges[k], 0, kMaxAllowance);
    }
};

inline constexpr auto kNotchFields = [](auto& at, auto& chosen) {
    at.need("line");
    at.id("line", chosen.line);
    at.field("at", chosen.at, -kMaxTurns, kMaxTurns);
    at.field("reversed", chosen.reversed);
    at.field("isThere", chosen.isThere);
    at.field("count", chosen.count, 1, 2);
};

inline constexpr auto kNotchRuleFields = [](auto& at, auto& rules) {
    at.field("automatic", rules.automatic);
    at.word(Setting{"form", TR("Form"), TR("Form of notches"), TR("How a notch is cut or drawn"),
                    nullptr, kNotchFormNames},
            rules.form, kNotchFormWords);
    at.field(Setting{"depth", TR("Depth"), TR("Depth of notches"),
                     TR("Measured inwards from the cutting line; at most half the allowance, if "
                        "there is one")},
             rules.depth, kMinNotchDepth, kMaxNotchDepth);
    at.list("notches", rules.notches, kNotchFields);
};

inline constexpr auto kDartFields = [](auto& at, auto& chosen) {
    at.need("left");
    at.object("left", chosen.seam.left, kStretchFields);
    at.object("right", chosen.seam.right, kStretchFields);
    at.field(
        Setting{
            "intake", TR("&Intake"), TR("Intake of a dart"),
            TR("Width between the legs at the edge, in the pattern; the legs keep their length"),
            TR("As flattened")},
        chosen.intake, kMinIntake, kMaxIntake);
    at.word(Setting{"lay", TR("Fol&d"), TR("Fold of a dart"),
                    TR("Leg over which the closed dart is folded, counted anti-clockwise around "
                       "the piece. By convention: towards the centre, or downwards"),
                    TR("By convention"), kDartLayNames},
            chosen.lay, kDartLayWords);
};

inline constexpr auto kFacingFields = [](auto& at, auto& facing) {
    at.need("edges");
    at.text("name", facing.name);
    at.list("edges", facing.edges, kStretchFields);
    at.field("width", facing.width, kMinStrip, kMaxStrip);
};

inline constexpr auto kInternalLineFields = [](auto& at, auto& line) {
    at.need("points");
    at.text("name", line.name);
    at.list("points", line.points, [](auto& in, auto& point) {
        in.need("at");
        in.point("at", point);
    });
    at.field("closed", line.closed);
};

inline constexpr auto kLabelFields = [](auto& at, auto& label) {
    at.text(Setting{"size", TR("Si&ze"), TR("Size on labels"),
                    TR("Size printed on the labels of all pieces")},
            label.size);
    at.text(Setting{"date", TR("&Date"), TR("Date on labels"),
                    TR("Date printed on the labels of all pieces")},
            label.date);
};

inline constexpr auto kLineFields = [](auto& at, auto& lines) {
    at.object(
        Setting{"fairing", TR("&Fair lines"), TR("Fair lines"),
                TR("Draw every line as a smooth curve of the same length, near the exact outline")},
        lines.fairing, kFairingFields);
    at.field(
        Setting{.key = "trueBelow",
                .title = TR("S&mooth corners up to"),
                .name = TR("Smooth corners at seams"),
                .help = TR(
                    "Remove kinks of up to this angle where lines meet at the end of a sewn seam"),
                .quantity = Quantity::Angle,
                .hasSwitch = true},
        lines.trueBelow, 0, kMaxKink);
    at.word("mirror", lines.mirror, kMirrorWords);
    at.list("segments", lines.segments, kSegmentFields);
    at.list("turnPoints", lines.turnPoints, kTurnPointFields);
    at.list("seamEnds", lines.seamEnds, kSeamEndFields);
    at.object(Setting{"allowance", TR("Seam &allowance"), TR("Seam allowance"),
                      TR("Add cloth beyond the seam lines, and a cutting line around it")},
              lines.allowance, kAllowanceFields);
    at.object(Setting{"notches", TR("&Notches"), TR("Notches"),
                      TR("Mark points of seams to align when sewing")},
              lines.notches, kNotchRuleFields);
    at.word("grain", lines.grain, kGrainRuleWords);
    const auto list = [&at](const char* name, auto& things, const auto& describe) {
        if (at.kReads || !things.empty()) {
            at.list(name, things, describe);
        }
    };
    list("darts", lines.darts, kDartFields);
    list("facings", lines.facings, kFacingFields);
    list("internalLines", lines.internalLines, kInternalLineFields);
    if (at.kReads || !(lines.label == LabelTexts{})) {
        at.object("label", lines.label, kLabelFields);
    }
};

}  // namespace toile
