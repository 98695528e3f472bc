// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/pattern/dart_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/geometry/line.h"
#include "core/pattern/segments.h"

namespace toile::test {
namespace {

using Eigen::Vector2d;

/// Begins the line's measure later.
template <class Stretch>
void shift(std::vector<Stretch>& stretches, const geometry::Line& line, double by) {
    for (Stretch& stretch : stretches) {
        const double length = stretch.to - stretch.from;
        stretch.from = line.wrap(stretch.from - by);
        stretch.to = stretch.from + length;
    }
}

template <class Stretch>
void reverse(std::vector<Stretch>& stretches, const geometry::Line& line) {
    for (Stretch& stretch : stretches) {
        const double length = stretch.to - stretch.from;
        stretch.from = line.wrap(line.length() - stretch.to);
        stretch.to = stretch.from + length;
    }
}

bool isTurn(const geometry::Line& line, int row) {
    return std::abs(line.turnAt(row)) > kLineCorner.turn;
}

}  // namespace

Points2 asOutline(const Corners& points) {
    Points2 outline(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t k = 0; k < points.size(); ++k) {
        outline.row(static_cast<Eigen::Index>(k)) = points[k];
    }
    return outline;
}

PatternPiece pieceWithDarts(const Corners& outline, const std::vector<DartRows>& darts,
                            std::vector<int> turns) {
    PatternPiece piece{{}, "piece", "piece", asOutline(outline)};
    const auto line = geometry::Line::closed(piece.outline);
    const auto stretch = [&](int from, int to) {
        const double first = line.arc()[from], last = line.arc()[to];
        return std::pair(first, last > first ? last : last + line.length());
    };
    int number = 0;
    for (const DartRows& dart : darts) {
        ++number;
        for (const bool isRight : {false, true}) {
            SeamLine& side = piece.seams.emplace_back();
            side.number = number;
            side.kind = SeamKind::Dart;
            side.isRight = isRight;
            side.seam = SeamId{static_cast<std::uint64_t>(number)};
            std::tie(side.from, side.to) =
                isRight ? stretch(dart.tip, dart.to) : stretch(dart.from, dart.tip);
        }
        turns.insert(turns.end(), {dart.from, dart.tip, dart.to});
    }
    std::ranges::sort(turns);
    turns.erase(std::unique(turns.begin(), turns.end()), turns.end());
    for (std::size_t k = 0; k < turns.size(); ++k) {
        PatternSegment& segment = piece.segments.emplace_back();
        std::tie(segment.from, segment.to) = stretch(turns[k], turns[(k + 1) % turns.size()]);
        segment.isCorner = isTurn(line, turns[k]);
        segment.length = segment.to - segment.from;
        segment.kind = SeamKind::Seam;
        for (const SeamLine& side : piece.seams) {
            if (segment.from >= side.from && segment.to <= side.to) {
                segment.kind = SeamKind::Dart;
                segment.seam = side.number;
                segment.isRight = side.isRight;
            }
        }
    }
    return piece;
}

PatternPiece ClosedDart::opened() const {
    const Eigen::Rotation2Dd turn(-angle);
    Corners outline;
    const auto addTurned = [&](const Vector2d& p) { outline.push_back(tip + turn * (p - tip)); };
    for (const Vector2d& p : left) {
        addTurned(p);
    }
    DartRows rows;
    rows.from = static_cast<int>(outline.size());
    addTurned(mouth);
    for (const Vector2d& p : leg) {
        addTurned(p);
    }
    rows.tip = static_cast<int>(outline.size());
    outline.push_back(tip);
    outline.insert(outline.end(), leg.rbegin(), leg.rend());
    rows.to = static_cast<int>(outline.size());
    outline.push_back(mouth);
    outline.insert(outline.end(), right.begin(), right.end());
    const int last = static_cast<int>(outline.size()) - 1;
    outline.emplace_back(300, 300);
    outline.emplace_back(-300, 300);
    return pieceWithDarts(outline, {rows}, {0, last, last + 1, last + 2});
}

PatternPiece begunAt(const PatternPiece& piece, int row) {
    PatternPiece begun = piece;
    const auto line = geometry::Line::closed(piece.outline);
    for (int k = 0; k < line.count(); ++k) {
        begun.outline.row(k) = piece.outline.row((k + row) % line.count());
    }
    shift(begun.seams, line, line.arc()[row]);
    shift(begun.segments, line, line.arc()[row]);
    std::ranges::stable_sort(begun.segments, {}, &PatternSegment::from);
    return begun;
}

PatternPiece moved(PatternPiece piece, double angle, const Eigen::RowVector2d& by) {
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
    piece.outline = (piece.outline * turn.transpose()).rowwise() + by;
    piece.grain = grainOf(piece) + angle;
    return piece;
}

PatternPiece mirrored(PatternPiece piece) {
    const auto before = geometry::Line::closed(piece.outline);
    piece.outline = piece.outline.colwise().reverse().eval();
    piece.outline.col(0) *= -1;
    // Row 0 was the last one: the measure begins there.
    reverse(piece.seams, before);
    reverse(piece.segments, before);
    const double last = before.length() - before.arc()[before.count() - 1];
    const auto line = geometry::Line::closed(piece.outline);
    shift(piece.seams, line, last);
    shift(piece.segments, line, last);
    for (PatternSegment& segment : piece.segments) {
        segment.isCorner = isTurn(line, line.edgeAt(segment.from + 1e-9));
    }
    for (SeamLine& side : piece.seams) {
        side.isRight = !side.isRight;
    }
    std::ranges::stable_sort(piece.segments, {}, &PatternSegment::from);
    piece.grain = std::numbers::pi - grainOf(piece);
    return piece;
}

}  // namespace toile::test
