// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/facings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <polyclipping/clipper.hpp>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/piece_allowance.h"
#include "core/seam/seam_settings.h"

namespace toile {
namespace {

constexpr double kStripGrid = 2e-6;  // mm: integer unit of the Clipper library
constexpr double kOnOutline = 1e-4;  // mm: tolerance for points of the strip on the outline
constexpr double kRoundness = 0.01;  // mm: of the inner edge around a corner of the run
constexpr double kMostlyFaced = 0.5;

ClipperLib::Path onGrid(const Points2& line) {
    ClipperLib::Path path;
    path.reserve(static_cast<std::size_t>(line.rows()));
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
        path.emplace_back(std::llround(line(k, 0) / kStripGrid),
                          std::llround(line(k, 1) / kStripGrid));
    }
    return path;
}

Points2 offGrid(const ClipperLib::Path& path) {
    Points2 line(path.size(), 2);
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
        line.row(k) << kStripGrid * static_cast<double>(path[k].X),
            kStripGrid * static_cast<double>(path[k].Y);
    }
    return line;
}

/// Neighbouring segments: first index and count.
struct Run {
    std::size_t first = 0, count = 0;
};

std::vector<Run> runsOf(const PatternPiece& piece, const Facing& facing) {
    const std::size_t n = piece.segments.size();
    std::vector<bool> faced;
    for (const PatternSegment& segment : piece.segments) {
        faced.push_back(isFaced(segment.place, facing));
    }
    std::vector<Run> runs;
    for (std::size_t k = 0; k < n; ++k) {
        if (faced[k] && !faced[(k + n - 1) % n]) {
            std::size_t count = 1;
            while (faced[(k + count) % n]) {
                ++count;
            }
            runs.push_back({k, count});
        }
    }
    if (n > 0 && std::ranges::all_of(faced, std::identity())) {
        runs.push_back({0, n});  // a whole outline, which gets no strip
    }
    return runs;
}

/// A line continued straight beyond its ends if the outline turns inwards there.
Points2 prolonged(const Points2& run, double width, bool atStart, bool atEnd) {
    const Eigen::Index n = run.rows();
    Points2 line = run;
    const auto beyond = [width](const Eigen::RowVector2d& from, const Eigen::RowVector2d& to) {
        return Eigen::RowVector2d(to + width * (to - from).normalized());
    };
    if (atStart) {
        line.row(0) = beyond(run.row(1), run.row(0));
    }
    if (atEnd) {
        line.row(n - 1) = beyond(run.row(n - 2), run.row(n - 1));
    }
    return line;
}

/// The part of the piece within `width` of a line that contains a place on the line.
std::optional<Points2> within(const PatternPiece& piece, const Points2& line, double width,
                              const Eigen::RowVector2d& place) {
    ClipperLib::ClipperOffset offset(2, kRoundness / kStripGrid);
    offset.AddPath(onGrid(line), ClipperLib::jtRound, ClipperLib::etOpenButt);
    ClipperLib::Paths strip, parts;
    offset.Execute(strip, width / kStripGrid);
    ClipperLib::Clipper clipper;
    clipper.AddPaths(strip, ClipperLib::ptSubject, true);
    clipper.AddPath(onGrid(piece.outline), ClipperLib::ptClip, true);
    clipper.Execute(ClipperLib::ctIntersection, parts, ClipperLib::pftNonZero,
                    ClipperLib::pftNonZero);
    // A strip whose ends meet is a ring, and would include the area inside it.
    if (std::ranges::any_of(parts, [](const auto& part) { return ClipperLib::Area(part) < 0; })) {
        return std::nullopt;
    }
    std::optional<Points2> nearest;
    double least = kOnOutline;
    for (const ClipperLib::Path& part : parts) {
        const Points2 points = offGrid(part);
        for (Eigen::Index k = 0; k < points.rows(); ++k) {
            const double distance = geometry::distanceToSegment(
                place, Eigen::RowVector2d(points.row(k)),
                Eigen::RowVector2d(points.row((k + 1) % points.rows())));
            if (distance < least) {
                least = distance;
                nearest = points;
            }
        }
    }
    return nearest;
}

Eigen::Index nearestRow(const Points2& line, const Eigen::RowVector2d& point) {
    Eigen::Index nearest = 0;
    (line.rowwise() - point).rowwise().squaredNorm().minCoeff(&nearest);
    return nearest;
}

/// Builds a strip along a run.
class Strip {
public:
    Strip(const PatternPiece& piece, const Run& run, double width)
        : piece_(piece),
          outline_(geometry::Line::closed(piece.outline)),
          run_(run),
          width_(width) {}

    /// Nothing if the strip has no room.
    std::optional<PatternPiece> make() {
        const double length = outline_.length();
        const double from = segment(0).from;
        double to = from;
        for (std::size_t k = 0; k < run_.count; ++k) {
            to += segment(k).to - segment(k).from;
        }
        const Points2 line = outline_.part(from, to);
        const bool isOpen = to - from < length - kOnOutline;
        if (!isOpen || line.rows() < 2 || to - from < kOnOutline) {
            return std::nullopt;
        }
        const auto part = within(piece_, prolonged(line, width_, turnsIn(from), turnsIn(to)),
                                 width_, outline_.pointAt(0.5 * (from + to)));
        if (!part) {
            return std::nullopt;
        }
        return made(line, *part);
    }

private:
    const PatternSegment& segment(std::size_t k) const {
        return piece_.segments[(run_.first + k) % piece_.segments.size()];
    }

    /// Whether the outline turns left at the start or end of a stretch.
    bool turnsIn(double at) const {
        const Eigen::RowVector2d there = outline_.pointAt(at);
        const Eigen::RowVector2d before = there - outline_.pointAt(at - 1);
        const Eigen::RowVector2d after = outline_.pointAt(at + 1) - there;
        return geometry::cross(before, after) > 0;
    }

    /// The strip with the exact run instead of its copy on the grid.
    std::optional<PatternPiece> made(const Points2& line, const Points2& part) const {
        const Eigen::Index n = part.rows(), m = line.rows();
        const Eigen::Index first = nearestRow(part, line.row(0));
        const Eigen::Index last = nearestRow(part, line.row(m - 1));
        if ((part.row(first) - line.row(0)).norm() > kOnOutline ||
            (part.row(last) - line.row(m - 1)).norm() > kOnOutline || first == last) {
            return std::nullopt;
        }
        const Eigen::Index rest = (first - last + n) % n - 1;
        if (rest < 1) {
            return std::nullopt;
        }
        PatternPiece strip;
        strip.outline.resize(m + rest, 2);
        strip.outline.topRows(m) = line;
        for (Eigen::Index k = 0; k < rest; ++k) {
            strip.outline.row(m + k) = part.row((last + 1 + k) % n);
        }
        strip.isFine = piece_.isFine;
        addRun(strip);
        addRest(strip, m);
        return strip;
    }

    /// Adds the segments and seams of the run.
    void addRun(PatternPiece& strip) const {
        double at = 0;
        for (std::size_t k = 0; k < run_.count; ++k) {
            PatternSegment& added = strip.segments.emplace_back(segment(k));
            added.to = at + (added.to - added.from);
            added.from = std::exchange(at, added.to);
            added.extension = 0;
            added.isCorner = added.isCorner || k == 0;
            const auto seam = std::ranges::find_if(piece_.seams, [&](const SeamLine& one) {
                return one.number == added.seam && one.isRight == added.isRight;
            });
            if (seam != piece_.seams.end()) {
                SeamLine& copy = strip.seams.emplace_back(*seam);
                copy.line = outline_.part(segment(k).from, segment(k).to);
                copy.from = added.from;
                copy.to = added.to;
                copy.closed = false;
            }
        }
    }

    /// Adds the segments of the other edges: with the neighbours' allowances along the outline,
    /// without allowance inside it.
    void addRest(PatternPiece& strip, Eigen::Index from) const {
        const auto line = geometry::Line::closed(strip.outline);
        const Eigen::Index n = strip.outline.rows();
        const auto ownerOf = [&](Eigen::Index k) {
            const Eigen::RowVector2d middle =
                0.5 * (strip.outline.row(k) + strip.outline.row((k + 1) % n));
            const double place = outline_.nearestPlace(middle);
            const bool isOn = (outline_.pointAt(place) - middle).norm() < kOnOutline;
            return isOn ? segmentAt(piece_, outline_.length(), place) : -1;
        };
        int before = -2;
        for (Eigen::Index k = from - 1; k < n; ++k) {
            const int owner = ownerOf(k);
            if (owner != std::exchange(before, owner)) {
                PatternSegment& added = strip.segments.emplace_back();
                added.from = line.arc()[k];
                added.isCorner = true;
                if (owner >= 0) {
                    added.allowance = piece_.segments[owner].allowance;
                    added.kind = SeamKind::Seam;
                }
            }
            strip.segments.back().to = line.arc()[k + 1];
            strip.segments.back().length = strip.segments.back().to - strip.segments.back().from;
        }
    }

    const PatternPiece& piece_;
    const geometry::Line outline_;
    const Run run_;
    const double width_;
};

}  // namespace

bool isFaced(const LineStretch& place, const Facing& facing) {
    double share = 0;
    for (const LineStretch& edge : facing.edges) {
        share += covered(place, edge);
    }
    return share > kMostlyFaced;
}

Points2 innerEdge(const PatternPiece& strip) {
    const auto outline = geometry::Line::closed(strip.outline);
    double from = 0;
    for (const PatternSegment& segment : strip.segments) {
        from = segment.place.line ? segment.to : from;
    }
    return outline.part(from, outline.length());
}

std::vector<FacingPiece> facingsOf(const Pattern& pattern, const std::vector<Facing>& facings) {
    std::vector<FacingPiece> made;
    for (std::size_t f = 0; f < facings.size(); ++f) {
        for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
            const PatternPiece& piece = pattern.pieces[p];
            if (piece.outline.rows() < 3) {
                continue;
            }
            for (const Run& run : runsOf(piece, facings[f])) {
                FacingPiece& one = made.emplace_back();
                one.piece = static_cast<int>(p);
                one.facing = static_cast<int>(f);
                one.strip = Strip(piece, run, facings[f].width).make().value_or(PatternPiece{});
                one.strip.name =
                    facings[f].name.empty() ? piece.name + ", facing" : facings[f].name;
                if (piece.cuttingLine.rows() > 0 && one.strip.outline.rows() > 0) {
                    addCuttingLine(one.strip);
                }
            }
        }
    }
    return made;
}

}  // namespace toile
