// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/segment.h"

namespace toile {
namespace {

/// An end closer to a rim than this is on it, mm.
constexpr double kReachesRim = 1;

/// Number of handles of a loop with fewer than two shared points.
constexpr int kSpread = 4;

bool goesRound(const UserCut& cut) {
    return cut.kind == UserCut::Kind::Loop;
}

std::array<double, 3> bitsOf(const Eigen::Vector3d& p) {
    return {p.x(), p.y(), p.z()};
}

/// The point nearest to a share of the cut's length from a given point.
int indexAt(const UserCut& cut, int from, double part) {
    const int n = static_cast<int>(cut.points.size());
    const double aim = part * lengthAlong(cut);
    double along = 0;
    for (int k = 0; k < n; ++k) {
        const Eigen::Vector3d& a = cut.points[static_cast<std::size_t>((from + k) % n)];
        const Eigen::Vector3d& b = cut.points[static_cast<std::size_t>((from + k + 1) % n)];
        const double step = (b - a).norm();
        if (along + step / 2 >= aim) {
            return (from + k) % n;
        }
        along += step;
    }
    return (from + n - 1) % n;
}

}  // namespace

double lengthAlong(const UserCut& cut) {
    double length = 0;
    for (std::size_t k = 1; k < cut.points.size(); ++k) {
        length += (cut.points[k] - cut.points[k - 1]).norm();
    }
    if (goesRound(cut) && !cut.points.empty()) {
        length += (cut.points.front() - cut.points.back()).norm();
    }
    return length;
}

std::vector<int> handlesOf(const std::vector<UserCut>& cuts, std::size_t cut) {
    const UserCut& of = cuts[cut];
    std::set<std::array<double, 3>> shared;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        for (const Eigen::Vector3d& point : cuts[k].points) {
            if (k != cut) {
                shared.insert(bitsOf(point));
            }
        }
    }
    const int last = static_cast<int>(of.points.size()) - 1;
    std::set<int> handles;
    for (int k = 0; k <= last; ++k) {
        const bool isEnd = !goesRound(of) && (k == 0 || k == last);
        if (isEnd || shared.contains(bitsOf(of.points[static_cast<std::size_t>(k)]))) {
            handles.insert(k);
        }
    }
    if (goesRound(of) && handles.size() < 2 && last >= 0) {
        const int from = handles.empty() ? 0 : *handles.begin();
        for (int k = 0; k < kSpread; ++k) {
            handles.insert(indexAt(of, from, static_cast<double>(k) / kSpread));
        }
    } else if (!goesRound(of) && handles.size() == 2 && of.kind != UserCut::Kind::Dart) {
        handles.insert(indexAt(of, 0, 0.5));
    }
    return {handles.begin(), handles.end()};
}

CutShaper::CutShaper(std::shared_ptr<const Piece> piece)
    : piece_(std::move(piece)), nearest_(piece_->mesh) {
    geometry::DisjointSets sets(static_cast<int>(piece_->mesh.V.rows()));
    for (int e = 0; e < piece_->table.edges.rows(); ++e) {
        if (piece_->table.isBorder(e)) {
            rim_.push_back(e);
            sets.join(piece_->table.edges(e, 0), piece_->table.edges(e, 1));
        }
    }
    for (const int e : rim_) {
        rimSet_.push_back(sets.root(piece_->table.edges(e, 0)));
    }
}

Eigen::Vector3d CutShaper::onSurface(const Eigen::Vector3d& point) const {
    return positionOf(piece_->mesh, nearest_.find(point));
}

CutShaper::RimPlace CutShaper::nearestRim(const Eigen::Vector3d& point) const {
    RimPlace nearest{-1, point, std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; k < rim_.size(); ++k) {
        const auto ends = piece_->table.edges.row(rim_[k]);
        const Eigen::Vector3d a = piece_->mesh.V.row(ends[0]), b = piece_->mesh.V.row(ends[1]);
        const Eigen::Vector3d there = a + geometry::nearestShare(point, a, b) * (b - a);
        const double distance = (there - point).norm();
        if (distance < nearest.distance) {
            nearest = {static_cast<int>(k), there, distance};
        }
    }
    return nearest;
}

Eigen::Vector3d CutShaper::onRim(const Eigen::Vector3d& point) const {
    return nearestRim(point).point;
}

bool CutShaper::isOnRim(const Eigen::Vector3d& point) const {
    return nearestRim(point).distance < kReachesRim;
}

std::vector<Eigen::Vector3d> CutShaper::rimThrough(const Eigen::Vector3d& point,
                                                   double spacing) const {
    std::vector<Eigen::Vector3d> places;
    const RimPlace on = nearestRim(point);
    for (std::size_t k = 0; on.distance < kReachesRim && k < rim_.size(); ++k) {
        if (rimSet_[k] != rimSet_[static_cast<std::size_t>(on.index)]) {
            continue;
        }
        const Eigen::Vector3d a = piece_->mesh.V.row(piece_->table.edges(rim_[k], 0));
        const Eigen::Vector3d b = piece_->mesh.V.row(piece_->table.edges(rim_[k], 1));
        const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing)));
        for (int part = 0; part <= parts; ++part) {
            places.emplace_back(a + (static_cast<double>(part) / parts) * (b - a));
        }
    }
    return places;
}

void CutShaper::move(std::vector<UserCut>& cuts, std::size_t cut, int point,
                     const Eigen::Vector3d& to) const {
    const Eigen::Vector3d from = cuts[cut].points[static_cast<std::size_t>(point)];
    struct Moved {
        std::size_t cut;
        int point;
        std::vector<int> handles;
    };
    std::vector<Moved> moved;
    bool isEnd = false;
    for (std::size_t c = 0; c < cuts.size(); ++c) {
        const int last = static_cast<int>(cuts[c].points.size()) - 1;
        for (int k = 0; k <= last; ++k) {
            const bool isThis = c == cut && k == point;
            if (isThis || cuts[c].points[static_cast<std::size_t>(k)] == from) {
                moved.push_back({c, k, handlesOf(cuts, c)});
                isEnd = isEnd || (!goesRound(cuts[c]) && (k == 0 || k == last));
            }
        }
    }
    const Eigen::Vector3d there = isEnd && isOnRim(from) ? onRim(to) : onSurface(to);
    for (const Moved& one : moved) {
        moveOne(cuts[one.cut], one.point, one.handles, there);
    }
}

void CutShaper::moveOne(UserCut& cut, int point, const std::vector<int>& handles,
                        const Eigen::Vector3d& to) const {
    const int n = static_cast<int>(cut.points.size());
    const std::vector<Eigen::Vector3d> before = cut.points;
    const auto at = [&before, n](int k) -> const Eigen::Vector3d& {
        return before[static_cast<std::size_t>((k % n + n) % n)];
    };
    const Eigen::Vector3d way = to - at(point);
    const auto isHeld = [&](int k) { return std::ranges::binary_search(handles, (k % n + n) % n); };
    for (const int step : {-1, 1}) {
        std::vector<std::pair<int, double>> between;  // with their distance along the line
        double length = 0;
        for (int k = point + step; goesRound(cut) ? (k - point) % n != 0 : k >= 0 && k < n;
             k += step) {
            length += (at(k) - at(k - step)).norm();
            if (isHeld(k)) {
                break;
            }
            between.emplace_back(k, length);
        }
        for (const auto& [k, along] : between) {
            const double share = length > 0 ? along / length : 0;
            cut.points[static_cast<std::size_t>((k % n + n) % n)] =
                onSurface(at(k) + (1 - share) * way);
        }
    }
    cut.points[static_cast<std::size_t>(point)] = to;
}

std::vector<Eigen::Vector3d> CutShaper::drawn(const UserCut& cut, double spacing) const {
    std::vector<Eigen::Vector3d> line;
    const std::size_t n = cut.points.size();
    for (std::size_t k = 0; k + (goesRound(cut) ? 0 : 1) < n; ++k) {
        const Eigen::Vector3d& a = cut.points[k];
        const Eigen::Vector3d& b = cut.points[(k + 1) % n];
        const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / spacing)));
        line.push_back(a);
        for (int part = 1; part < parts; ++part) {
            line.push_back(onSurface(a + (static_cast<double>(part) / parts) * (b - a)));
        }
    }
    if (n > 0) {
        line.push_back(goesRound(cut) ? cut.points.front() : cut.points.back());
    }
    return line;
}

}  // namespace toile
