// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "core/cut/face_parts.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

/// Two opposite angles must exceed pi by this much before their edge is turned; this keeps four
/// points on a circle from being turned for ever.
constexpr double kTurnable = 1e-9;
/// A part made by a turn has at least this share of the area of the two it comes from.
constexpr double kLeastShare = 1e-6;
/// For each part, should rounding turn edges to and fro.
constexpr std::size_t kMostTurns = 100;

double angle(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

/// A source triangle laid flat at its true size.
class FlatFace {
public:
    FlatFace(const FaceParts& parts, int face) : parts_(parts), face_(face) {
        const MeshArrays& mesh = parts.links().mesh();
        const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 0));
        const Eigen::Vector3d b = mesh.V.row(mesh.F(face, 1)).transpose() - a;
        const Eigen::Vector3d c = mesh.V.row(mesh.F(face, 2)).transpose() - a;
        const double length = b.norm();
        corners_.col(0).setZero();
        corners_.col(1) << length, 0;
        corners_.col(2) << b.dot(c) / length, b.cross(c).norm() / length;
    }

    Eigen::Vector2d at(int vertex) const { return corners_ * parts_.weightsIn(face_, vertex); }

private:
    const FaceParts& parts_;
    int face_;
    Eigen::Matrix<double, 2, 3> corners_;
};

/// True where the edge a-b between the corners c (left) and d (right) should run from c to d.
bool shouldTurn(const FlatFace& flat, int a, int b, int c, int d) {
    const Eigen::Vector2d pa = flat.at(a);
    const Eigen::Vector2d pb = flat.at(b);
    const Eigen::Vector2d pc = flat.at(c);
    const Eigen::Vector2d pd = flat.at(d);
    const double whole = cross(pb - pa, pc - pa) + cross(pa - pb, pd - pb);
    const double least = kLeastShare * whole;
    return angle(pa - pc, pb - pc) + angle(pa - pd, pb - pd) > std::numbers::pi + kTurnable &&
           cross(pd - pa, pc - pa) > least && cross(pc - pb, pd - pb) > least;
}

}  // namespace

void FaceParts::relaxFace(int face, std::vector<Part>& list,
                          const std::set<VertexPair>& kept) const {
    const FlatFace flat(*this, face);
    std::map<VertexPair, std::size_t> partLeftOf;  // of directed sides
    std::set<VertexPair> open;                     // those whose two parts are not known to be good
    const auto addSidesOf = [&](std::size_t part) {
        for (int k = 0; k < 3; ++k) {
            const int a = list[part][k];
            const int b = list[part][(k + 1) % 3];
            partLeftOf[{a, b}] = part;
            open.insert(std::minmax(a, b));
        }
    };
    for (std::size_t p = 0; p < list.size(); ++p) {
        addSidesOf(p);
    }
    const std::size_t limit = kMostTurns * list.size();
    for (std::size_t turns = 0; !open.empty() && turns < limit;) {
        std::set<std::size_t> changed;  // in this round, and done with until the next
        for (const auto& [a, b] : std::exchange(open, {})) {
            const auto left = partLeftOf.find({a, b});
            const auto right = partLeftOf.find({b, a});
            if (left == partLeftOf.end() || right == partLeftOf.end() || kept.contains({a, b}) ||
                changed.contains(left->second) || changed.contains(right->second)) {
                continue;
            }
            const std::size_t p = left->second;
            const std::size_t q = right->second;
            const int c = list[p][0] + list[p][1] + list[p][2] - a - b;
            const int d = list[q][0] + list[q][1] + list[q][2] - a - b;
            if (shouldTurn(flat, a, b, c, d)) {
                list[p] = {a, d, c};
                list[q] = {b, c, d};
                partLeftOf.erase(left);
                partLeftOf.erase(right);
                addSidesOf(p);
                addSidesOf(q);
                changed.insert({p, q});
                ++turns;
            }
        }
    }
}

void FaceParts::relax(const std::set<VertexPair>& kept, const Progress& progress) {
    for (std::size_t i = 0; i < split_.size() && !progress.isCancelled(); ++i) {
        relaxFace(splitFace_[i], split_[i], kept);
    }
}

}  // namespace toile
