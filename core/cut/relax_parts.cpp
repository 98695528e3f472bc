// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "core/cut/face_parts.h"
#include "core/mesh/segment.h"

namespace toile {
namespace {

/// Two opposite angles must exceed pi by this much before their edge is turned; this keeps four
/// points on a circle from being turned for ever.
constexpr double kTurnable = 1e-9;
/// A part made by a turn has at least this share of the area of the two it comes from.
constexpr double kLeastShare = 1e-6;

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
    const std::size_t limit = 10 * list.size() * list.size();
    std::size_t turns = 0;
    for (bool again = true; again && turns < limit;) {
        again = false;
        std::map<VertexPair, std::size_t> sides;  // directed: the part on its left
        for (std::size_t p = 0; p < list.size(); ++p) {
            for (int k = 0; k < 3; ++k) {
                sides[{list[p][k], list[p][(k + 1) % 3]}] = p;
            }
        }
        std::set<std::size_t> changed;  // their sides are out of date until the next round
        for (const auto& [side, p] : sides) {
            const auto [a, b] = side;
            const auto other = sides.find({b, a});
            if (a > b || other == sides.end() || kept.contains(side) || changed.contains(p) ||
                changed.contains(other->second)) {
                continue;
            }
            const auto third = [&list](std::size_t part, int x, int y) {
                return list[part][0] + list[part][1] + list[part][2] - x - y;
            };
            const int c = third(p, a, b);
            const int d = third(other->second, a, b);
            if (shouldTurn(flat, a, b, c, d)) {
                list[p] = {a, d, c};
                list[other->second] = {b, c, d};
                changed.insert({p, other->second});
                again = true;
                ++turns;
            }
        }
    }
}

void FaceParts::relax(const std::set<VertexPair>& kept) {
    for (std::size_t i = 0; i < split_.size(); ++i) {
        relaxFace(splitFace_[i], split_[i], kept);
    }
}

}  // namespace toile
