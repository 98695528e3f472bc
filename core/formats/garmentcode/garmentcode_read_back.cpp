// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/text.h"
#include "core/formats/garmentcode/garmentcode_reader.h"
#include "core/formats/garmentcode/garmentcode_writer.h"
#include "core/geometry/line.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

/// The point on a line, near an expected place, that is nearest to a point.
double placeNear(const geometry::Line& line, double expected, const Eigen::RowVector2d& point) {
    constexpr double kReach = 2;  // mm
    double best = expected, least = (line.pointAt(expected) - point).norm();
    const int first = line.edgeAt(expected - kReach);
    const int steps = (line.edgeAt(expected + kReach) - first + line.count()) % line.count() + 1;
    for (int s = 0; s < steps; ++s) {
        const int k = (first + s) % line.count();
        const Eigen::RowVector2d a = line.points().row(k),
                                 b = line.points().row((k + 1) % line.count());
        const double share = geometry::nearestShare(point, a, b);
        const double distance = (a + share * (b - a) - point).norm();
        const double from = line.arc()[static_cast<std::size_t>(k)],
                     to = line.arc()[static_cast<std::size_t>(k) + 1];
        if (distance < least - 1e-12) {
            const double place = from + share * (to - from);
            least = distance;
            best = expected + std::remainder(place - expected, line.length());
        }
    }
    return best;
}

/// Compares a panel of a file with its piece.
class PanelCheck {
public:
    PanelCheck(const PatternPiece& piece, const GarmentCodePanel& panel)
        : piece_(piece), panel_(panel), line_(geometry::Line::closed(piece.outline)) {}

    /// The error, or the largest deviation of the file.
    Result<double> check() {
        double at = piece_.segments.front().from, largest = 0, total = 0;
        for (const GarmentCodeEdge& edge : panel_.edges) {
            const Eigen::RowVector2d from = edge.curves.front().start.transpose(),
                                     to = edge.curves.back().end.transpose();
            const double begin = placeNear(line_, at, from);
            const double end = placeNear(line_, begin + edge.length, to);
            const double off =
                std::max((line_.pointAt(begin) - from).norm(), (line_.pointAt(end) - to).norm());
            if (!(off <= kReadBackCoordinates)) {
                return notReadBack(panel_.name, fixed(off, 3) + " mm from its outline");
            }
            const double difference = std::abs(end - begin - edge.length);
            if (!(difference <= kReadBackLengths)) {
                return notReadBack(panel_.name,
                                   "an edge is off by " + fixed(difference, 3) + " mm in length");
            }
            largest = std::max({largest, off, difference});
            places_.push_back((begin + end) / 2);
            total += edge.length;
            at = end;
        }
        const double difference = std::abs(total - line_.length());
        const double allowed =
            kReadBackLengths * std::max<double>(1, static_cast<double>(piece_.segments.size()));
        if (!(difference <= allowed)) {
            return notReadBack(panel_.name,
                               "its outline is off by " + fixed(difference, 3) + " mm");
        }
        return std::max(largest, difference);
    }

    /// The segment that contains an edge.
    const PatternSegment* segmentOf(int edge) const {
        const double place = places_[static_cast<std::size_t>(edge)];
        for (const PatternSegment& segment : piece_.segments) {
            const double middle = (segment.from + segment.to) / 2;
            if (std::abs(std::remainder(place - middle, line_.length())) <=
                (segment.to - segment.from) / 2) {
                return &segment;
            }
        }
        return nullptr;
    }

private:
    const PatternPiece& piece_;
    const GarmentCodePanel& panel_;
    geometry::Line line_;
    std::vector<double> places_;  ///< of the middles of edges
};

}  // namespace

Result<ReadBack> readBackGarmentCode(const std::string& bytes, const Pattern& pattern) {
    if (std::ranges::all_of(pattern.pieces,
                            [](const auto& piece) { return piece.outline.rows() == 0; })) {
        return ReadBack{};  // without panels the file is no valid specification to read
    }
    const auto code = readGarmentCode(bytes);
    if (!code) {
        return notReadBack(pattern.name, sentence(code.error()));
    }
    ReadBack found;
    std::vector<PanelCheck> checks;
    for (const PatternPiece& piece : pattern.pieces) {
        if (piece.outline.rows() == 0 || piece.segments.empty()) {
            continue;
        }
        const auto index = static_cast<std::size_t>(found.pieces);
        if (index >= code->panels.size() || code->panels[index].name != piece.slug) {
            return notReadBack(piece.name, "it is missing");
        }
        auto& check = checks.emplace_back(piece, code->panels[index]);
        const Result<double> off = check.check();
        if (!off) {
            return off.error();
        }
        found.largest = std::max(found.largest, *off);
        ++found.pieces;
    }
    if (static_cast<std::size_t>(found.pieces) != code->panels.size()) {
        return notReadBack(pattern.name, "it has panels that are not in the pattern");
    }
    // The stretches that stitches cover on each side of a seam.
    std::map<std::pair<int, bool>, double> covered;
    for (const GarmentCodeStitch& stitch : code->stitches) {
        const PatternSegment* segments[2] = {};
        for (std::size_t k = 0; k < 2; ++k) {
            const auto [panel, edge] = stitch.sides[k];
            segments[k] = checks[static_cast<std::size_t>(panel)].segmentOf(edge);
            if (segments[k]) {
                covered[{segments[k]->seam, segments[k]->isRight}] +=
                    code->panels[static_cast<std::size_t>(panel)]
                        .edges[static_cast<std::size_t>(edge)]
                        .length;
            }
        }
        if (!segments[0] || !segments[1] || segments[0]->seam != segments[1]->seam ||
            segments[0]->isRight == segments[1]->isRight) {
            return notReadBack(pattern.name, "a stitch joins edges that are not sewn together");
        }
    }
    std::map<std::pair<int, bool>, std::pair<double, int>> sewn;
    for (const PatternPiece& piece : pattern.pieces) {
        for (const PatternSegment& segment : piece.segments) {
            auto& [length, count] = sewn[{segment.seam, segment.isRight}];
            length += segment.to - segment.from;
            ++count;
        }
    }
    for (const auto& [side, length] : covered) {
        const auto& [meant, count] = sewn.at(side);
        if (!(std::abs(length - meant) <= kReadBackLengths * count)) {
            return notReadBack("seam " + std::to_string(side.first),
                               "its stitches differ by " + fixed(length - meant, 3) + " mm");
        }
        found.largest = std::max(found.largest, std::abs(length - meant));
    }
    found.seams = static_cast<int>(covered.size()) / 2;
    return found;
}

}  // namespace toile
