// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/segment.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace toile::geometry {
namespace {

/// Half a unit in the last place of 1, and the bound of the rounding error of a determinant of
/// differences relative to the sum of its two products' sizes ([She97] section 4.3).
constexpr double kHalfUlp = 0x1p-53;
constexpr double kFilter = (3 + 16 * kHalfUlp) * kHalfUlp;

/// A sum of doubles that do not overlap, smallest first: its sign is that of the last nonzero one.
/// Each added double lengthens it by one.
class Expansion {
public:
    void add(double value) {
        double carried = value;
        for (int k = 0; k < count_; ++k) {
            // The rounding error of a sum is itself a double (Knuth): store it, carry the sum on.
            const double sum = carried + terms_[k];
            const double part = sum - carried;
            terms_[k] = (carried - (sum - part)) + (terms_[k] - part);
            carried = sum;
        }
        terms_[count_++] = carried;
    }

    void addProduct(double x, double y) {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }

    int sign() const {
        for (int k = count_; k-- > 0;) {
            if (terms_[k] != 0) {
                return terms_[k] > 0 ? 1 : -1;
            }
        }
        return 0;
    }

private:
    std::array<double, 12> terms_{};
    int count_ = 0;
};

}  // namespace

int exactOrientation(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
                     const Eigen::RowVector2d& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    const double determinant = left - right;
    if (std::abs(determinant) > kFilter * (std::abs(left) + std::abs(right))) {
        return determinant > 0 ? 1 : -1;
    }
    Expansion exact;  // of the coordinates themselves: differences may be rounded
    exact.addProduct(a.x(), b.y());
    exact.addProduct(-a.y(), b.x());
    exact.addProduct(b.x(), c.y());
    exact.addProduct(-b.y(), c.x());
    exact.addProduct(c.x(), a.y());
    exact.addProduct(-c.y(), a.x());
    return exact.sign();
}

NearestOnLine::NearestOnLine(const Polygon& closed) : points_(closed) {
    std::vector<std::uint32_t> edges;  // triangles without area
    const auto count = static_cast<std::uint32_t>(closed.rows());
    for (std::uint32_t k = 0; k < count; ++k) {
        edges.insert(edges.end(), {k, (k + 1) % count, k});
    }
    tree_ = TriangleTree<2, double>(points_.data(), 2, edges);
}

Eigen::RowVector2d NearestOnLine::operator()(const Eigen::RowVector2d& point) const {
    using Tree = TriangleTree<2, double>;
    Eigen::RowVector2d best = points_.row(0);
    std::pair least(std::numeric_limits<double>::infinity(), Eigen::Index{0});
    tree_.search(
        [&](const Tree::Box& box) {
            const Eigen::Map<const Eigen::RowVector2d> low(box.low.data()), high(box.high.data());
            const double square = (point.cwiseMax(low).cwiseMin(high) - point).squaredNorm();
            return square <= least.first ? square : Tree::kMissed;
        },
        [&](Eigen::Index k) {
            const Eigen::RowVector2d a = points_.row(k), b = points_.row((k + 1) % points_.rows());
            const Eigen::RowVector2d place = a + nearestShare(point, a, b) * (b - a);
            // Of equally close places take the first along the line, in any order of visits.
            if (const std::pair found((place - point).squaredNorm(), k); found < least) {
                least = found;
                best = place;
            }
        });
    return best;
}

}  // namespace toile::geometry
