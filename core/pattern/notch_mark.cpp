// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/notch_mark.h"

#include <algorithm>
#include <utility>

#include "core/geometry/segment.h"
#include "core/pattern/half_pattern.h"
#include "core/pattern/internal_lines.h"
#include "core/pattern/piece_allowance.h"

namespace toile {
namespace {

/// A place relative to a notch: along the seam line, and inwards from the cutting line, mm.
struct BesideNotch {
    double along = 0, inwards = 0;
};

std::vector<std::vector<BesideNotch>> strokesOf(NotchForm form, double depth, double width) {
    const double half = 0.5 * width;
    switch (form) {
        case NotchForm::V:
            return {{{-half, 0}, {0, depth}, {half, 0}}};
        case NotchForm::T:
            return {{{0, 0}, {0, depth}}, {{-half, depth}, {half, depth}}};
        case NotchForm::Castle:
            return {{{-half, 0}, {-half, depth}, {half, depth}, {half, 0}}};
        case NotchForm::Slit:
            break;
    }
    return {{{0, 0}, {0, depth}}};
}

}  // namespace

NotchSpot notchSpot(const geometry::Line& line, double place) {
    const Eigen::RowVector2d chord =
        line.pointAt(place + kHalfChord) - line.pointAt(place - kHalfChord);
    const Eigen::Vector2d along = chord.transpose().normalized();
    return {line.pointAt(place).transpose(), -geometry::leftOf(along)};
}

std::vector<Points2> notchStrokes(const NotchSpot& spot, double allowance, NotchForm form,
                                  int count, const NotchSize& size) {
    const double depth = allowance > 0 ? std::min(size.depth, 0.5 * allowance) : size.depth;
    const Eigen::Vector2d along = geometry::leftOf(spot.outward);
    std::vector<Points2> strokes;
    for (int k = 0; k < count; ++k) {
        const double shift = size.spacing * (k - 0.5 * (count - 1));
        for (const auto& stroke : strokesOf(form, depth, size.width)) {
            Points2 line(static_cast<Eigen::Index>(stroke.size()), 2);
            for (Eigen::Index i = 0; i < line.rows(); ++i) {
                const BesideNotch& at = stroke[static_cast<std::size_t>(i)];
                line.row(i) = spot.point + (shift + at.along) * along +
                              (allowance - at.inwards) * spot.outward;
            }
            strokes.push_back(std::move(line));
        }
    }
    return strokes;
}

geometry::Line notchLine(const PatternPiece& piece, int hole) {
    if (hole >= 0) {
        return geometry::Line::closed(piece.holes[static_cast<std::size_t>(hole)]);
    }
    if (piece.cutAs != CutAs::OnFold) {
        return geometry::Line::closed(piece.outline);
    }
    const Eigen::Index n = piece.outline.rows();
    const Chord fold = foldOf(piece);
    const Eigen::RowVector2d from = fold.from.transpose();
    const Eigen::RowVector2d along = (fold.to - fold.from).normalized().transpose();
    Points2 whole(2 * n - 2, 2);
    whole.topRows(n) = piece.outline;
    for (Eigen::Index k = 1; k < n - 1; ++k) {
        const Eigen::RowVector2d way = piece.outline.row(k) - from;
        whole.row(2 * n - 2 - k) = from + 2 * way.dot(along) * along - way;
    }
    return geometry::Line::closed(std::move(whole));
}

std::vector<std::vector<Points2>> notchMarks(const Pattern& pattern, const PatternPiece& piece,
                                             std::optional<NotchForm> form) {
    std::vector<geometry::Line> loops;
    loops.reserve(piece.holes.size() + 1);
    for (int hole = -1; hole < static_cast<int>(piece.holes.size()); ++hole) {
        loops.push_back(notchLine(piece, hole));
    }
    NotchSize size;
    size.depth = pattern.notchDepth;
    std::vector<std::vector<Points2>> marks;
    marks.reserve(piece.notches.size());
    for (const PieceNotch& notch : piece.notches) {
        const int index = notch.hole + 1;  // 0 is the outline
        const geometry::Line& loop = loops[static_cast<std::size_t>(index)];
        const double allowance = notch.hole < 0 ? allowanceAt(piece, loop.length(), notch.at) : 0;
        std::vector<Points2> strokes =
            notchStrokes(notchSpot(loop, notch.at), allowance, form.value_or(pattern.notchForm),
                         notch.count, size);
        if (piece.cutAs == CutAs::OnFold) {
            strokes = leftParts(strokes, foldOf(piece));
        }
        marks.push_back(std::move(strokes));
    }
    return marks;
}

}  // namespace toile
