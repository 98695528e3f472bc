// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/drawing/sheet_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "core/formats/read_back.h"
#include "core/geometry/line.h"
#include "core/pattern/curve_fit.h"
#include "core/pattern/label.h"

namespace toile {
namespace {

/// Maximum distance of curves from the drawn line, mm; otherwise it is written by its points.
constexpr double kCurvesWithin = 0.015;
constexpr double kLengthWithin = 0.04;  // mm, of the whole line
/// Curves are sampled so that chords stay within this distance of them, mm.
constexpr double kTriedWithin = 0.001;
constexpr double kMaxTried = 1000;  // samples of a curve

constexpr double kSewDash = 4, kSewGap = 2;        // mm
constexpr double kHiddenDash = 6, kHiddenGap = 3;  // mm, of lines that are not sewn

CubicCurve placedCurve(const CubicCurve& curve, const Placement& placement) {
    const auto at = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
        return placement.applied(p);
    };
    if (placement.mirrored) {
        return {at(curve.end), at(curve.endHandle), at(curve.startHandle), at(curve.start),
                curve.isLine};
    }
    return {at(curve.start), at(curve.startHandle), at(curve.endHandle), at(curve.end),
            curve.isLine};
}

/// Points on joined curves, close enough for chords to replace the curves.
Points2 placesOn(const std::vector<CubicCurve>& chain) {
    std::vector<Eigen::Vector2d> places;
    for (const CubicCurve& curve : chain) {
        const double bend = std::max((curve.start - 2 * curve.startHandle + curve.endHandle).norm(),
                                     (curve.startHandle - 2 * curve.endHandle + curve.end).norm());
        const double count =
            std::clamp(std::ceil(std::sqrt(0.75 * bend / kTriedWithin)), 1.0, kMaxTried);
        for (int k = 0; k < count; ++k) {
            places.push_back(curve.at(k / count));
        }
    }
    if (!chain.empty()) {
        places.push_back(chain.back().end);
    }
    Points2 points(static_cast<Eigen::Index>(places.size()), 2);
    for (std::size_t k = 0; k < places.size(); ++k) {
        points.row(static_cast<Eigen::Index>(k)) = places[k].transpose();
    }
    return points;
}

double openLength(const Points2& points) {
    const Eigen::Index steps = points.rows() - 1;
    return (points.bottomRows(steps) - points.topRows(steps)).rowwise().norm().sum();
}

/// Whether curves coincide with the points of a part of a line.
bool isSameLine(const std::vector<CubicCurve>& curves, const Points2& part) {
    if (curves.empty() || part.rows() < 2) {
        return false;
    }
    const ReadLine line{.points = placesOn(curves)};
    return distanceBetween(line, {{}, LayerKind::Sew, part, false}) <= kCurvesWithin;
}

std::vector<CubicCurve> edgesBetween(const Points2& points) {
    std::vector<CubicCurve> edges;
    for (Eigen::Index k = 0; k + 1 < points.rows(); ++k) {
        edges.push_back(straightCurve(points.row(k), points.row(k + 1)));
    }
    return edges;
}

/// The placed outline of a piece, in the direction of the drawn line: each segment as curves, or by
/// its points if the curves leave the line. None if the segments do not form a loop.
std::vector<CubicCurve> outlineCurves(const PatternPiece& piece, const Placement& placement) {
    const auto outline = geometry::Line::closed(piece.outline);
    std::vector<CubicCurve> chain;
    double longer = 0;
    for (const PatternSegment& segment : piece.segments) {
        const Points2 part = outline.part(segment.from, segment.to);
        std::vector<CubicCurve> curves = curvesOf(piece, outline, segment);
        if (isSameLine(curves, part)) {
            longer += openLength(placesOn(curves)) - openLength(part);
        } else {
            curves = edgesBetween(part);
        }
        for (const CubicCurve& curve : curves) {
            chain.push_back(placedCurve(curve, placement));
        }
    }
    const double turn =
        piece.segments.empty() ? 0 : piece.segments.back().to - piece.segments.front().from;
    const bool isWhole =
        std::abs(longer) <= kLengthWithin && std::abs(turn - outline.length()) <= kCurvesWithin;
    if (placement.mirrored) {
        std::ranges::reverse(chain);
    }
    return isWhole ? chain : std::vector<CubicCurve>{};
}

class PatternDrawer {
public:
    PatternDrawer(SheetCanvas& out, const Drawing& drawing, const Pattern& pattern,
                  const SheetLineWidths& widths)
        : out_(out),
          drawing_(drawing),
          pattern_(pattern),
          widths_(widths),
          blockOf_(drawing.paths.size()) {
        for (const DrawnBlock& block : drawing.blocks) {
            std::fill_n(blockOf_.begin() + static_cast<std::ptrdiff_t>(block.path), block.pathCount,
                        &block);
        }
    }

    void drawLayer(LayerKind layer) {
        out_.beginLayer(static_cast<int>(layer));
        out_.save();
        setStyle(layer);
        for (std::size_t k = 0; k < drawing_.paths.size(); ++k) {
            if (drawing_.paths[k].layer == layer) {
                drawPath(k);
            }
        }
        for (const DrawnText& text : drawing_.texts) {
            if (text.layer == layer) {
                drawText(text);
            }
        }
        out_.restore();
        out_.end();
    }

private:
    void setStyle(LayerKind layer) {
        out_.setGrey(0);
        out_.setWidth(layer == LayerKind::Cut     ? widths_.cut
                      : layer == LayerKind::Marks ? widths_.marks
                                                  : widths_.others);
        if (layer == LayerKind::Sew) {
            out_.setDashes(kSewDash, kSewGap);
        } else if (layer == LayerKind::Internal) {
            out_.setDashes(kHiddenDash, kHiddenGap);
        } else {
            out_.setRoundEnds();
        }
    }

    void drawPath(std::size_t index) {
        const DrawnPath& path = drawing_.paths[index];
        const DrawnBlock* block = blockOf_[index];
        out_.beginItem(path.id, block ? block->id : "");
        const std::vector<CubicCurve> chain = block ? curvesFor(*block, path) : decltype(chain){};
        if (chain.empty()) {
            out_.line(path.points, path.closed);
        } else {
            out_.curves(chain, true);
        }
        out_.end();
    }

    /// None if the path is not a curved outline.
    std::vector<CubicCurve> curvesFor(const DrawnBlock& block, const DrawnPath& path) const {
        if (block.piece < 0 || static_cast<std::size_t>(block.piece) >= pattern_.pieces.size()) {
            return {};
        }
        const PatternPiece& piece = pattern_.pieces[static_cast<std::size_t>(block.piece)];
        const bool isSeamLine =
            piece.cuttingLine.rows() > 0
                ? path.layer == LayerKind::Sew
                : path.layer == LayerKind::Cut && &path == &drawing_.paths[block.path];
        if (!piece.isFine || !isSeamLine) {
            return {};
        }
        return outlineCurves(piece, block.placement);
    }

    void drawText(const DrawnText& text) {
        const Eigen::Vector2d down = Eigen::Rotation2Dd(text.angle) * Eigen::Vector2d(0, -1);
        Eigen::Vector2d baseline = text.position + 0.5 * text.height * down;
        for (const std::string& line : text.lines) {
            out_.text(line, baseline, text.height, TextStart::Middle, text.angle);
            baseline += kLineSpacing * text.height * down;
        }
    }

    SheetCanvas& out_;
    const Drawing& drawing_;
    const Pattern& pattern_;
    SheetLineWidths widths_;
    std::vector<const DrawnBlock*> blockOf_;  ///< of each path; null: of the page
};

}  // namespace

void drawPattern(SheetCanvas& out, const Drawing& drawing, const Pattern& pattern,
                 const std::vector<LayerKind>& layers, const SheetLineWidths& widths) {
    PatternDrawer drawer(out, drawing, pattern, widths);
    for (const LayerKind layer : layers) {
        drawer.drawLayer(layer);
    }
}

}  // namespace toile
