// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/rolled_piece.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/document/line_edits.h"
#include "app/render/colour_map.h"
#include "app/render/render_style.h"
#include "app/views/tool.h"
#include "core/pattern/notch_mark.h"

namespace toile::app {

namespace {

constexpr int kRolledFill = 150;  // of 255: translucent
constexpr double kRolledOutline = 1.4, kWalkedLine = 2.4, kWalkedHalo = 4.8, kNotchStroke = 1.6,
                 kTouching = 5;  // pixels
constexpr int kFramedShares = 8;

/// Maps a line of a piece to the screen through its placement on the sheet.
template <class OnSheet>
QPolygonF lineOnScreen(const Points2& line, const SheetMap& map, const OnSheet& onSheet) {
    QPolygonF drawn;
    drawn.reserve(line.rows());
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
        drawn << map(onSheet(line.row(k).transpose()));
    }
    return drawn;
}

/// The part of a side between two arc lengths in 3D.
Points2 walkedPart(const DrawnLoop& loop, double from, double to) {
    const auto [low, high] = std::minmax({loop.flatAt(from), loop.flatAt(to)});
    return loop.flat.part(low, high);
}

}  // namespace

std::optional<RolledPiece> RolledPiece::of(const Document& document, int seam) {
    if (seam < 0 || seam >= document.seamCount()) {
        return std::nullopt;
    }
    const Seam& of = document.garment()->seams.seams[static_cast<std::size_t>(seam)];
    DrawnLoops loops(document.results());
    const auto isFlat = [&](const SeamSide& side) {
        return document.patternPiece(side.piece) && loops.isFlat(side);
    };
    if (of.matches.empty() || !isFlat(of.left) || !isFlat(of.right)) {
        return std::nullopt;
    }
    return RolledPiece(document, seam, {of, loops});
}

RolledPiece::RolledPiece(const Document& document, int seam, SeamRoll roll)
    : seam_(seam),
      colour_(document.colourOf(roll.seam().right.piece)),
      roll_(std::move(roll)),
      pattern_(document.derived().pattern) {
    for (const SeamNotch& notch : notchesOf(*pattern_)) {
        if (notch.seam == seam) {
            notches_.push_back(notch.share);
        }
    }
    std::ranges::sort(notches_);
    lyingStrokes_ = strokesOf(lying(), true);
    rollingStrokes_ = strokesOf(rolling(), false);
    rollTo(0);
}

std::vector<Points2> RolledPiece::strokesOf(const PatternPiece& piece, bool ofSeamOnly) const {
    std::vector<Points2> strokes;
    for (int hole = -1; hole < static_cast<int>(piece.holes.size()); ++hole) {
        std::optional<geometry::Line> loop;
        for (const PieceNotch& notch : piece.notches) {
            if (notch.hole != hole || (ofSeamOnly && notch.seam != seam_ + 1)) {
                continue;
            }
            if (!loop) {
                loop = geometry::Line::closed(
                    hole < 0 ? piece.outline : piece.holes[static_cast<std::size_t>(hole)]);
            }
            NotchSize size;
            size.depth = pattern_->notchDepth;
            std::ranges::move(
                notchStrokes(notchSpot(*loop, notch.at), 0, pattern_->notchForm, notch.count, size),
                std::back_inserter(strokes));
        }
    }
    return strokes;
}

void RolledPiece::rollTo(double share) {
    share_ = share;
    now_ = roll_.at(share);
}

double RolledPiece::along() const {
    const SeamSide& left = seamOf().left;
    return (now_.at.left - left.start) / (left.end - left.start);
}

Eigen::AlignedBox2d RolledPiece::wayOnSheet(const SheetPlaces& places) const {
    const Placement& place = placeOf(places, seamOf().left.piece).placement;
    Eigen::AlignedBox2d box = outlineBox(lying().outline, place);
    for (int k = 0; k <= kFramedShares; ++k) {
        const Placement motion = roll_.at(static_cast<double>(k) / kFramedShares).motion;
        const Points2& outline = rolling().outline;
        for (Eigen::Index i = 0; i < outline.rows(); ++i) {
            box.extend(place.applied(motion.applied(outline.row(i).transpose())));
        }
    }
    return box;
}

void RolledPiece::paint(QPainter& painter, const RenderStyle& style, const Camera2D& camera,
                        const SheetPlaces& places) const {
    const Placement& place = placeOf(places, seamOf().left.piece).placement;
    const SheetMap map(camera);
    const auto lies = [&](const Eigen::Vector2d& point) { return place.applied(point); };
    const auto rolls = [&](const Eigen::Vector2d& point) {
        return place.applied(now_.motion.applied(point));
    };
    QPainterPath cloth;
    cloth.addPolygon(lineOnScreen(rolling().outline, map, rolls));
    cloth.closeSubpath();
    for (const Points2& hole : rolling().holes) {
        cloth.addPolygon(lineOnScreen(hole, map, rolls));
        cloth.closeSubpath();
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const Rgb rgb = pieceColour(colour_);
    painter.setBrush(QColor(rgb.r, rgb.g, rgb.b, kRolledFill));
    painter.setPen(QPen(style.outline, kRolledOutline, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(cloth);

    const QPolygonF line =
        lineOnScreen(walkedPart(roll_.left(), seamOf().left.start, now_.at.left), map, lies);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] :
         {std::pair(style.seamHalo, kWalkedHalo), {style.seam, kWalkedLine}}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    }
    painter.setPen(
        QPen(style.cuttingLine, kNotchStroke, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    for (const Points2& stroke : lyingStrokes_) {
        painter.drawPolyline(lineOnScreen(stroke, map, lies));
    }
    for (const Points2& stroke : rollingStrokes_) {
        painter.drawPolyline(lineOnScreen(stroke, map, rolls));
    }
    paintSeamDot(painter, style, map(lies(roll_.left().pointAt(now_.at.left).transpose())));
    painter.restore();
}

void paintSeamDot(QPainter& painter, const RenderStyle& style, const QPointF& at) {
    painter.setPen(QPen(style.seamHalo, 2));
    painter.setBrush(style.seam);
    painter.drawEllipse(at, kTouching, kTouching);
}

}  // namespace toile::app
