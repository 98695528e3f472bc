// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/extension.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/geometry/segment.h"
#include "core/pattern/piece_allowance.h"

namespace toile {
namespace {

/// mm: tolerance for finding points of the outline again.
constexpr double kSamePoint = 1e-4;

/// Finds the stretches that the edges of an extended line belong to.
class Owners {
public:
    /// @param widths  of the extensions, one per stretch
    Owners(const CappedOutline& before, const std::vector<double>& widths, const Points2& line)
        : before_(before), widths_(widths), line_(line) {
        stretchAt_.reserve(static_cast<std::size_t>(count()));
        std::size_t next = 0;
        for (int i = 0; i < count(); ++i) {
            next += next < before.stretches.size() && before.stretches[next].first == i ? 1 : 0;
            stretchAt_.push_back(next > 0 ? next - 1 : before.stretches.size() - 1);
        }
        found_.reserve(static_cast<std::size_t>(line.rows()));
        int from = 0;
        for (Eigen::Index k = 0; k < line.rows(); ++k) {
            found_.push_back(find(line.row(k), from));
            from = found_.back() < 0 ? from : found_.back();
        }
    }

    bool isOnOutline(Eigen::Index k) const { return found_[at(k)] >= 0; }

    /// Owner of the edge from point k to the next.
    std::size_t of(Eigen::Index k) const {
        const int from = found_[at(k)], to = found_[at(k + 1)];
        if (from < 0 && to < 0) {
            return nearestDrawnOut(0.5 * (line_.row(k) + line_.row(at(k + 1))));
        }
        // The way to the extension and back belongs to the neighbouring stretch.
        const std::size_t n = widths_.size();
        const std::size_t stretch = stretchAt_[from >= 0 ? from : (to + count() - 1) % count()];
        const bool isStrip = widths_[stretch] > 0;
        return !isStrip ? stretch : to < 0 ? (stretch + n - 1) % n : (stretch + 1) % n;
    }

private:
    int count() const { return static_cast<int>(before_.line.rows()); }
    std::size_t at(Eigen::Index k) const { return static_cast<std::size_t>(k % line_.rows()); }

    /// The point's index in the original line; searches from `from` on, because most are in order.
    int find(const Eigen::RowVector2d& point, int from) const {
        for (int i = 0; i < count(); ++i) {
            const int k = (from + i) % count();
            if ((before_.line.row(k) - point).cwiseAbs().maxCoeff() < kSamePoint) {
                return k;
            }
        }
        return -1;
    }

    /// The extended stretch nearest to a place that is not on the original line.
    std::size_t nearestDrawnOut(const Eigen::RowVector2d& point) const {
        std::size_t nearest = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < count(); ++i) {
            const double width = widths_[stretchAt_[i]];
            const Eigen::RowVector2d a = before_.line.row(i);
            const Eigen::RowVector2d b = before_.line.row((i + 1) % count());
            const double distance = geometry::distanceToSegment(point, a, b);
            if (width > 0 && std::abs(distance - width) < least) {
                least = std::abs(distance - width);
                nearest = stretchAt_[i];
            }
        }
        return nearest;
    }

    const CappedOutline& before_;
    const std::vector<double>& widths_;
    const Points2& line_;
    std::vector<std::size_t> stretchAt_;  ///< of the original line, by the edge at each point
    std::vector<int> found_;              ///< index in the original line; -1: not one of its points
};

std::vector<double> widthsOf(const PatternPiece& piece, const CappedOutline& capped) {
    std::vector<double> widths;
    for (const CappedStretch& stretch : capped.stretches) {
        widths.push_back(stretch.segment < 0 ? 0 : extensionOf(piece.segments[stretch.segment]));
    }
    return widths;
}

}  // namespace

double extensionOf(const PatternSegment& segment) {
    return segment.seam > 0 && segment.kind == SeamKind::Free ? segment.extension : 0;
}

CappedOutline extendedOutline(const PatternPiece& piece, CappedOutline capped) {
    const std::vector<double> widths = widthsOf(piece, capped);
    if (std::ranges::all_of(widths, [](double width) { return width == 0; })) {
        return capped;
    }
    std::vector<AllowanceStretch> strips;
    for (std::size_t k = 0; k < widths.size(); ++k) {
        const CappedStretch& stretch = capped.stretches[k];
        const auto corner =
            stretch.segment < 0 ? std::nullopt : piece.segments[stretch.segment].corner;
        strips.push_back({stretch.first, widths[k], corner.value_or(CornerRule::Mitre)});
    }
    CappedOutline extended{cuttingLine(capped.line, strips), {}};
    const Owners owners(capped, widths, extended.line);
    const Eigen::Index count = extended.line.rows();
    for (Eigen::Index k = 0; k < count; ++k) {
        const std::size_t owner = owners.of(k);
        if (owner != owners.of((k + count - 1) % count)) {
            extended.stretches.push_back({static_cast<int>(k), capped.stretches[owner].segment});
        }
    }
    if (extended.stretches.empty()) {
        extended.stretches.push_back({0, capped.stretches[owners.of(0)].segment});
    }
    return extended;
}

std::vector<Points2> extensionEdges(const PatternPiece& piece, const CappedOutline& extended) {
    std::vector<Points2> edges;
    const int count = static_cast<int>(extended.line.rows());
    const std::size_t stretches = extended.stretches.size();
    for (std::size_t k = 0; k < stretches; ++k) {
        const auto [first, segment] = extended.stretches[k];
        if (segment < 0 || extensionOf(piece.segments[segment]) == 0) {
            continue;
        }
        const int next = extended.stretches[(k + 1) % stretches].first;
        const int edgesThere = stretches == 1 ? count : (next - first + count) % count;
        Points2& edge = edges.emplace_back(edgesThere + 1, 2);
        for (int i = 0; i <= edgesThere; ++i) {
            edge.row(i) = extended.line.row((first + i) % count);
        }
    }
    return edges;
}

}  // namespace toile
