// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/outline_terms.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/flatten/isometric/flat_energy.h"
#include "core/geometry/segment.h"

namespace toile::isometric {
namespace {

constexpr double kBarrierRadius = 0.1;  // of an edge
constexpr double kWeight = 1e-4;       // of all contacts together, in units of the isometric energy
constexpr double kMinGap = 0.3;        // share of the old distance that a step must leave
constexpr double kGapTolerance = 0.1;  // share of the distance that a step should leave

struct Box {
    Eigen::Array2d low, high;
};

/// From the nearest point of the contact's edge, at `place` along it, to the vertex.
Eigen::RowVector2d gapBetween(const Points2& Q, const OutlineBarrier::Contact& c, double& place) {
    const Eigen::RowVector2d edge = Q.row(c.to) - Q.row(c.from);
    const Eigen::RowVector2d to = Q.row(c.vertex) - Q.row(c.from);
    place = std::clamp(to.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    return to - place * edge;
}

/// Second derivative of the contact's energy by its distance.
double curvatureOf(const OutlineBarrier::Contact& c) {
    const double ratio = c.radius / c.distance;
    return 2 * c.weight * ratio * (3 * ratio - 2) / (c.distance * c.distance);
}

Box around(std::initializer_list<Eigen::RowVector2d> points, double margin) {
    Box box{*points.begin(), *points.begin()};
    for (const auto& p : points) {
        box.low = box.low.min(p.transpose().array());
        box.high = box.high.max(p.transpose().array());
    }
    box.low -= margin;
    box.high += margin;
    return box;
}

/// Calls `meet(i, j)` for every vertex box i and edge box j that overlap: a sweep along the longer
/// axis of the bounding box.
template <class Meet>
void forOverlaps(const std::vector<Box>& vertices, const std::vector<Box>& edges, Meet meet) {
    const auto n = static_cast<int>(vertices.size());
    Box whole = edges.front();
    for (const Box& box : edges) {
        whole.low = whole.low.min(box.low);
        whole.high = whole.high.max(box.high);
    }
    const Eigen::Array2d size = whole.high - whole.low;
    const int axis = size[0] >= size[1] ? 0 : 1;
    // Vertices are numbered 0 .. n-1, edges n .. 2n-1. Data of the sweep is contiguous.
    struct Item {
        double low, high, lowAcross, highAcross;
        int number;
    };
    std::vector<Item> items(2 * static_cast<std::size_t>(n));
    for (int k = 0; k < 2 * n; ++k) {
        const Box& box = k < n ? vertices[k] : edges[k - n];
        items[k] = {box.low[axis], box.high[axis], box.low[1 - axis], box.high[1 - axis], k};
    }
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
        return std::pair(a.low, a.number) < std::pair(b.low, b.number);
    });
    for (auto one = items.begin(); one != items.end(); ++one) {
        for (auto other = one + 1; other != items.end() && other->low <= one->high; ++other) {
            if (one->lowAcross <= other->highAcross && other->lowAcross <= one->highAcross &&
                (one->number < n) != (other->number < n)) {
                meet(std::min(one->number, other->number),
                     std::max(one->number, other->number) - n);
            }
        }
    }
}

}  // namespace

OutlineBending::OutlineBending(EdgeLoops loops, Eigen::VectorXd angles,
                               const Eigen::VectorXd& lengths, double stiffness)
    : loops_(std::move(loops)), angles_(std::move(angles)), weights_(lengths.size()) {
    const double whole = lengths.sum();
    for (int i = 0; i < loops_.count(); ++i) {
        weights_[i] = 0.5 * stiffness * (lengths[i] + lengths[loops_.previous(i)]) / whole;
    }
}

OutlineBending::Turn OutlineBending::turnAt(const Points2& Q, int i) const {
    Turn turn{};
    turn.vertex[0] = loops_.vertex(loops_.previous(i));
    turn.vertex[1] = loops_.vertex(i);
    turn.vertex[2] = loops_.end(i);
    const Eigen::RowVector2d next = Q.row(turn.vertex[2]) - Q.row(turn.vertex[1]);
    const Eigen::RowVector2d back = Q.row(turn.vertex[0]) - Q.row(turn.vertex[1]);
    // The inner angle: from the next edge anti-clockwise to the one before.
    const double theta = geometry::turnBetween(next, back);
    const double half = 0.5 * (theta - angles_[i]);
    turn.excess = 2 * std::sin(half);
    const auto turned = [](const Eigen::RowVector2d& e) -> Eigen::RowVector2d {
        return Eigen::RowVector2d(-e.y(), e.x()) / e.squaredNorm();
    };
    const double slope = std::cos(half);
    turn.slope[0] = slope * turned(back);
    turn.slope[2] = -slope * turned(next);
    turn.slope[1] = -turn.slope[0] - turn.slope[2];
    return turn;
}

double OutlineBending::energy(const Points2& Q) const {
    double sum = 0;
    for (int i = 0; i < loops_.count(); ++i) {
        const double excess = turnAt(Q, i).excess;
        sum += weights_[i] * excess * excess;
    }
    return sum;
}

void OutlineBending::addGradient(const Points2& Q, Points2& g) const {
    for (int i = 0; i < loops_.count(); ++i) {
        const Turn turn = turnAt(Q, i);
        for (int k = 0; k < 3; ++k) {
            g.row(turn.vertex[k]) += 2 * weights_[i] * turn.excess * turn.slope[k];
        }
    }
}

void OutlineBending::addHessian(const Points2& Q, linalg::BlockMatrix& hessian) const {
    for (int i = 0; i < loops_.count(); ++i) {
        const Turn turn = turnAt(Q, i);
        for (int a = 0; a < 3; ++a) {
            const Eigen::RowVector2d pull = 2 * weights_[i] * turn.slope[a];
            hessian.addVertex(turn.vertex[a], pull.transpose() * turn.slope[a]);
            for (int b = a + 1; b < 3; ++b) {
                // Store the block in the row of the larger vertex.
                const bool rises = turn.vertex[a] < turn.vertex[b];
                const Eigen::Matrix2d block = turn.slope[rises ? b : a].transpose() *
                                              turn.slope[rises ? a : b] * (2 * weights_[i]);
                hessian.addEdge(hessian.findEdge(turn.vertex[a], turn.vertex[b]), block);
            }
        }
    }
}

OutlineBarrier::OutlineBarrier(std::vector<int> boundary, const Eigen::VectorXd& lengths)
    : boundary_(std::move(boundary)),
      radius_(kBarrierRadius * lengths),
      weight_(kWeight / lengths.sum() * lengths) {}

Eigen::VectorXd OutlineBarrier::radius() const {
    const Eigen::Index n = radius_.size();
    Eigen::VectorXd radius(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        radius[i] = std::min(radius_[i], radius_[(i + n - 1) % n]);
    }
    return radius;
}

std::vector<OutlineBarrier::Contact> OutlineBarrier::contacts(const Points2& Q) const {
    const int n = static_cast<int>(boundary_.size());
    const auto vertexRadius = [ofVertex = radius()](int i) -> double { return ofVertex[i]; };
    std::vector<Box> vertices(n);
    std::vector<Box> edges(n);
    for (int i = 0; i < n; ++i) {
        vertices[i] = around({Q.row(boundary_[i])}, vertexRadius(i));
        edges[i] = around({Q.row(boundary_[i]), Q.row(boundary_[(i + 1) % n])}, 0);
    }
    std::vector<std::pair<int, int>> pairs;
    forOverlaps(vertices, edges, [&](int i, int j) {
        if (i != j && i != (j + 1) % n) {
            pairs.emplace_back(i, j);
        }
    });
    std::sort(pairs.begin(), pairs.end());  // fixed order of summation, for reproducible rounding
    std::vector<Contact> found;
    for (const auto& [i, j] : pairs) {
        Contact contact{};
        contact.vertex = boundary_[i];
        contact.from = boundary_[j];
        contact.to = boundary_[(j + 1) % n];
        contact.radius = std::min(vertexRadius(i), radius_[j]);
        contact.weight = weight_[i];
        const Eigen::RowVector2d gap = gapBetween(Q, contact, contact.place);
        contact.distance = gap.norm();
        if (contact.distance < contact.radius) {
            contact.away = gap / contact.distance;
            found.push_back(contact);
        }
    }
    return found;
}

double OutlineBarrier::energy(const std::vector<Contact>& contacts) {
    double sum = 0;
    for (const Contact& c : contacts) {
        const double over = c.radius / c.distance - 1;
        sum += c.weight * over * over;
    }
    return sum;
}

void OutlineBarrier::addGradient(const std::vector<Contact>& contacts, Points2& g) {
    for (const Contact& c : contacts) {
        const double slope =
            -2 * c.weight * (c.radius / c.distance - 1) * c.radius / (c.distance * c.distance);
        g.row(c.vertex) += slope * c.away;
        g.row(c.from) -= slope * (1 - c.place) * c.away;
        g.row(c.to) -= slope * c.place * c.away;
    }
}

void OutlineBarrier::addHessian(const std::vector<Contact>& contacts,
                                linalg::BlockMatrix& hessian) {
    for (const Contact& c : contacts) {
        const Eigen::Matrix2d block = curvatureOf(c) * c.away.transpose() * c.away;
        const int vertex[3] = {c.vertex, c.from, c.to};
        const double share[3] = {1, c.place - 1, -c.place};
        for (int a = 0; a < 3; ++a) {
            hessian.addVertex(vertex[a], share[a] * share[a] * block);
            for (int b = a + 1; b < 3; ++b) {
                hessian.addEdge(hessian.findEdge(vertex[a], vertex[b]),
                                share[a] * share[b] * block);
            }
        }
    }
}

bool OutlineBarrier::addOpeningForces(const std::vector<Contact>& contacts, const Points2& step,
                                      const Points2& moved, Points2& forces) {
    bool isNarrow = false;
    for (const Contact& c : contacts) {
        double place = 0;
        const Eigen::RowVector2d gap = gapBetween(moved, c, place);
        const Eigen::RowVector2d opened =
            step.row(c.vertex) - (1 - c.place) * step.row(c.from) - c.place * step.row(c.to);
        const double wanted = std::max(c.distance + opened.dot(c.away), kMinGap * c.distance);
        const double missing = wanted - std::copysign(gap.norm(), gap.dot(c.away));
        if (missing > kGapTolerance * wanted) {
            isNarrow = true;
            const Eigen::RowVector2d force = curvatureOf(c) * missing * c.away;
            forces.row(c.vertex) += force;
            forces.row(c.from) -= (1 - c.place) * force;
            forces.row(c.to) -= c.place * force;
        }
    }
    return isNarrow;
}

double OutlineBarrier::largestStep(const Points2& Q, const Points2& P, double limit) const {
    const int n = static_cast<int>(boundary_.size());
    const auto at = [&](int i) -> Eigen::RowVector2d { return Q.row(boundary_[i % n]); };
    const auto then = [&](int i) -> Eigen::RowVector2d {
        return at(i) + limit * P.row(boundary_[i % n]);
    };
    std::vector<Box> vertices(n);
    std::vector<Box> edges(n);
    for (int i = 0; i < n; ++i) {
        vertices[i] = around({at(i), then(i)}, 0);
        edges[i] = around({at(i), at(i + 1), then(i), then(i + 1)}, 0);
    }
    double most = limit;
    forOverlaps(vertices, edges, [&](int i, int j) {
        if (i == j || i == (j + 1) % n) {
            return;
        }
        // The vertex is in line with the edge when a t^2 + b t + c = 0.
        const Eigen::RowVector2d e = at(j + 1) - at(j);
        const Eigen::RowVector2d r = at(i) - at(j);
        const Eigen::RowVector2d de = P.row(boundary_[(j + 1) % n]) - P.row(boundary_[j]);
        const Eigen::RowVector2d dr = P.row(boundary_[i]) - P.row(boundary_[j]);
        const double a = geometry::cross(de, dr);
        const double b = geometry::cross(e, dr) + geometry::cross(de, r);
        const double c = geometry::cross(e, r);
        for (const double t : quadraticRoots(a, b, c)) {
            if (t > 0 && t < most) {
                const Eigen::RowVector2d edge = e + t * de;
                const double place = (r + t * dr).dot(edge) / edge.squaredNorm();
                if (place > -1e-6 && place < 1 + 1e-6) {
                    most = t;
                }
            }
        }
    });
    return most;
}

}  // namespace toile::isometric
