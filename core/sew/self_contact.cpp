// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/self_contact.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/cut/surface_point.h"
#include "core/geometry/triangle_tree.h"
#include "core/mesh/mesh_arrays.h"
#include "core/sew/side_by_side.h"
#include "core/sew/vertices_around.h"

namespace toile::sew {
namespace {

/// Bounding boxes of triangles on straight moves, in a tree for box queries. Immutable;
/// thread-safe.
class FaceBoxes {
public:
    /// Cost: n log n.
    FaceBoxes(const Points3& from, const Points3& to, const Triangles& F)
        : ends_(2 * F.rows(), 3), tree_(treeOf(from, to, F)) {}

    /// @param visit  called with the number of each triangle found, in unspecified order
    template <class Visit>
    void visitMet(const Eigen::RowVector3d& low, const Eigen::RowVector3d& high,
                  const Visit& visit) const {
        const auto isMet = [&](const auto& boxLow, const auto& boxHigh) {
            return (boxLow.array() <= high.array()).all() && (low.array() <= boxHigh.array()).all();
        };
        using Corner = Eigen::Map<const Eigen::RowVector3d>;
        const auto distanceTo = [&](const Tree::Box& box) {
            return isMet(Corner(box.low.data()), Corner(box.high.data())) ? 0 : Tree::kMissed;
        };
        tree_.search(distanceTo, [&](std::uint32_t face) {
            const auto row = 2 * static_cast<Eigen::Index>(face);
            if (isMet(ends_.row(row), ends_.row(row + 1))) {
                visit(static_cast<int>(face));
            }
        });
    }

private:
    using Tree = geometry::TriangleTree<3, double>;

    /// The tree stores a box as a triangle with its lowest and highest corner.
    Tree treeOf(const Points3& from, const Points3& to, const Triangles& F) {
        std::vector<std::uint32_t> diagonals;
        diagonals.reserve(static_cast<std::size_t>(F.size()));
        for (Eigen::Index f = 0; f < F.rows(); ++f) {
            Eigen::RowVector3d low = from.row(F(f, 0)), high = low;
            for (int k = 0; k < 3; ++k) {
                low = low.cwiseMin(from.row(F(f, k))).cwiseMin(to.row(F(f, k)));
                high = high.cwiseMax(from.row(F(f, k))).cwiseMax(to.row(F(f, k)));
            }
            ends_.row(2 * f) = low;
            ends_.row(2 * f + 1) = high;
            const auto first = static_cast<std::uint32_t>(2 * f);
            diagonals.insert(diagonals.end(), {first, first + 1, first + 1});
        }
        return {ends_.data(), 3, diagonals};
    }

    Points3 ends_;  ///< two per triangle: the lowest corner of its box and the highest
    Tree tree_;
};

constexpr int kRings = 2;
constexpr double kApart = 3;  // times the thickness, along the cloth
/// Smallest fraction of a distance that remains after a step; share of the allowed loss used at
/// once.
constexpr double kLeft = 0.1, kBold = 0.9;
/// Fraction of the thickness: closer contacts are released so that layers do not stick.
constexpr double kLost = 1e-3;
constexpr int kMaxAdvances = 200;

struct Corners {
    Eigen::Vector3d p, a, b, c;

    Eigen::Vector3d nearest() const { return nearestInTriangle(p, a, b, c); }
    Eigen::Vector3d offset(const Eigen::Vector3d& weights) const {
        return p - weights[0] * a - weights[1] * b - weights[2] * c;
    }
    double distance() const { return offset(nearest()).norm(); }
};

Corners cornersOf(const Points3& X, const Triangles& F, int vertex, int face) {
    return {X.row(vertex).transpose(), X.row(F(face, 0)).transpose(), X.row(F(face, 1)).transpose(),
            X.row(F(face, 2)).transpose()};
}

/// How far a vertex and a triangle may move along a step, by advances that cannot collide.
double freeWayOf(const Corners& at, const Corners& step, double lost, double most) {
    const double speed =
        std::max({(step.p - step.a).norm(), (step.p - step.b).norm(), (step.p - step.c).norm()});
    const double first = at.distance(), least = kLeft * first;
    if (first < lost || first - least > speed * most) {
        return most;
    }
    double way = 0, distance = first;
    for (int k = 0; k < kMaxAdvances; ++k) {
        const double advance = kBold * (distance - least) / speed;
        way += advance;
        if (way >= most) {
            return most;
        }
        const Corners now{at.p + way * step.p, at.a + way * step.a, at.b + way * step.b,
                          at.c + way * step.c};
        distance = now.distance();
        if (distance - least < kLeft * least) {
            break;
        }
    }
    return way;
}

}  // namespace

SelfContact::SelfContact(const Cloth& cloth, double thickness, int threads,
                         const Progress& progress)
    : cloth_(cloth),
      thickness_(thickness),
      threads_(threads),
      areas_(vertexAreas(cloth)),
      kin_(static_cast<std::size_t>(cloth.X.rows())) {
    std::vector<std::vector<int>> seeds(kin_.size());
    for (std::size_t v = 0; v < seeds.size(); ++v) {
        seeds[v] = {static_cast<int>(v)};
    }
    for (const Touch& touch : touchesAt(cloth.X, thickness, progress)) {
        for (int k = 0; k < 3; ++k) {
            const int corner = cloth.F(touch.face, k);
            seeds[touch.vertex].push_back(corner);
            seeds[corner].push_back(touch.vertex);
        }
    }
    const Neighbours neighbours = neighboursOf(cloth);
    stretchesSideBySide(threads, kin_.size(), [&](std::size_t first, std::size_t last) {
        VerticesAround around(neighbours, kRings, kApart * thickness);
        for (std::size_t v = first; v < last && !progress.isCancelled(); ++v) {
            kin_[v] = around.of(seeds[v]);
        }
    });
}

bool SelfContact::belongTogether(int vertex, int face) const {
    const std::vector<int>& kin = kin_[vertex];
    for (int k = 0; k < 3; ++k) {
        const int corner = cloth_.F(face, k);
        if (corner == vertex || std::ranges::binary_search(kin, corner)) {
            return true;
        }
    }
    return false;
}

std::vector<SelfContact::Touch> SelfContact::touchesAt(const Points3& X, double within) const {
    return touchesAt(X, within, {});
}

std::vector<SelfContact::Touch> SelfContact::touchesAt(const Points3& X, double within,
                                                       const Progress& progress) const {
    const FaceBoxes boxes(X, X, cloth_.F);
    std::vector<std::vector<Touch>> found(kin_.size());
    sideBySide(threads_, found.size(), [&](std::size_t v) {
        if (progress.isCancelled()) {
            return;
        }
        const int vertex = static_cast<int>(v);
        const Eigen::RowVector3d p = X.row(vertex);
        boxes.visitMet(p.array() - within, p.array() + within, [&](int face) {
            if (belongTogether(vertex, face)) {
                return;
            }
            const Corners corners = cornersOf(X, cloth_.F, vertex, face);
            const Eigen::Vector3d weights = corners.nearest(), offset = corners.offset(weights);
            const double distance = offset.norm();
            if (distance < within) {
                found[v].push_back(
                    {vertex, static_cast<int>(face), weights,
                     distance > 0 ? Eigen::Vector3d(offset / distance) : Eigen::Vector3d::Zero(),
                     distance});
            }
        });
        std::ranges::sort(found[v], {}, &Touch::face);
    });
    std::vector<Touch> all;
    for (const auto& some : found) {
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

double SelfContact::freeWay(const Points3& X, const Points3& step) const {
    const Points3 ends = X + step;
    const FaceBoxes boxes(X, ends, cloth_.F);
    const double lost = kLost * thickness_;
    std::vector<double> free(kin_.size(), 1);
    sideBySide(threads_, free.size(), [&](std::size_t v) {
        const int vertex = static_cast<int>(v);
        const Eigen::RowVector3d from = X.row(vertex), to = ends.row(vertex);
        const Eigen::RowVector3d low = from.cwiseMin(to).array() - lost;
        const Eigen::RowVector3d high = from.cwiseMax(to).array() + lost;
        boxes.visitMet(low, high, [&](int face) {
            if (!belongTogether(vertex, face)) {
                free[v] = freeWayOf(cornersOf(X, cloth_.F, vertex, face),
                                    cornersOf(step, cloth_.F, vertex, face), lost, free[v]);
            }
        });
    });
    return free.empty() ? 1 : *std::ranges::min_element(free);
}

double SelfContact::energy(const std::vector<Touch>& touches, double stiffness) const {
    double sum = 0;
    for (const Touch& touch : touches) {
        const double inside = std::max(thickness_ - touch.distance, 0.0);
        sum += stiffness * areas_[touch.vertex] * inside * inside / 2;
    }
    return sum;
}

void SelfContact::addGradient(const std::vector<Touch>& touches, double stiffness,
                              Points3& g) const {
    for (const Touch& touch : touches) {
        const double inside = std::max(thickness_ - touch.distance, 0.0);
        const Eigen::RowVector3d push =
            stiffness * areas_[touch.vertex] * inside * touch.away.transpose();
        g.row(touch.vertex) -= push;
        for (int k = 0; k < 3; ++k) {
            g.row(cloth_.F(touch.face, k)) += touch.weights[k] * push;
        }
    }
}

void SelfContact::addHessian(const std::vector<Touch>& touches, double stiffness,
                             SpaceMatrix& H) const {
    for (const Touch& touch : touches) {
        if (touch.distance >= thickness_) {
            continue;
        }
        const Eigen::Matrix3d block =
            stiffness * areas_[touch.vertex] * touch.away * touch.away.transpose();
        const std::array<int, 4> vertex{touch.vertex, cloth_.F(touch.face, 0),
                                        cloth_.F(touch.face, 1), cloth_.F(touch.face, 2)};
        const std::array<double, 4> weight{1, -touch.weights[0], -touch.weights[1],
                                           -touch.weights[2]};
        for (int i = 0; i < 4; ++i) {
            for (int j = i; j < 4; ++j) {
                H.add(vertex[i], vertex[j], weight[i] * weight[j] * block);
            }
        }
    }
}

void SelfContact::addPairs(const std::vector<Touch>& touches,
                           std::vector<std::pair<int, int>>& pairs) const {
    for (const Touch& touch : touches) {
        for (int k = 0; k < 3; ++k) {
            pairs.emplace_back(touch.vertex, cloth_.F(touch.face, k));
        }
    }
}

}  // namespace toile::sew
