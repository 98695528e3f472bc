// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/nearest_surface.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace toile {
namespace {

constexpr int kLeafSize = 8;

}  // namespace

Eigen::Vector3d nearestInTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                  const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Eigen::Vector3d ab = b - a;
    const Eigen::Vector3d ac = c - a;
    const double d1 = ab.dot(p - a);
    const double d2 = ac.dot(p - a);
    if (d1 <= 0 && d2 <= 0) {
        return {1, 0, 0};
    }
    const double d3 = ab.dot(p - b);
    const double d4 = ac.dot(p - b);
    if (d3 >= 0 && d4 <= d3) {
        return {0, 1, 0};
    }
    const double d5 = ab.dot(p - c);
    const double d6 = ac.dot(p - c);
    if (d6 >= 0 && d5 <= d6) {
        return {0, 0, 1};
    }
    const double onAb = d1 * d4 - d3 * d2;
    if (onAb <= 0 && d1 >= 0 && d3 <= 0) {
        const double t = d1 / (d1 - d3);
        return {1 - t, t, 0};
    }
    const double onAc = d5 * d2 - d1 * d6;
    if (onAc <= 0 && d2 >= 0 && d6 <= 0) {
        const double t = d2 / (d2 - d6);
        return {1 - t, 0, t};
    }
    const double onBc = d3 * d6 - d5 * d4;
    if (onBc <= 0 && d4 >= d3 && d5 >= d6) {
        const double t = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - t, t};
    }
    const double sum = onAb + onAc + onBc;
    const Eigen::Vector3d weights(0, onAc / sum, onAb / sum);
    return {1 - weights[1] - weights[2], weights[1], weights[2]};
}

double NearestSurface::Box::squaredDistance(const Eigen::Vector3d& p) const {
    return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

NearestSurface::Box NearestSurface::boxAround(int first, int count) const {
    Box box{Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()),
            Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity()),
            first,
            count,
            -1,
            -1};
    for (int i = first; i < first + count; ++i) {
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d p = mesh_.V.row(mesh_.F(order_[i], k));
            box.low = box.low.cwiseMin(p);
            box.high = box.high.cwiseMax(p);
        }
    }
    return box;
}

NearestSurface::NearestSurface(const MeshArrays& mesh) : mesh_(mesh), order_(mesh.F.rows()) {
    std::iota(order_.begin(), order_.end(), 0);
    boxes_.push_back(boxAround(0, static_cast<int>(order_.size())));
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
        const Box box = boxes_[b];
        if (box.count <= kLeafSize) {
            continue;
        }
        int axis = 0;
        (box.high - box.low).maxCoeff(&axis);
        const auto middle = [&](int f) {
            return mesh_.V(mesh_.F(f, 0), axis) + mesh_.V(mesh_.F(f, 1), axis) +
                   mesh_.V(mesh_.F(f, 2), axis);
        };
        const int half = box.count / 2;
        const auto begin = order_.begin() + box.first;
        std::nth_element(begin, begin + half, begin + box.count, [&](int f, int g) {
            return std::pair(middle(f), f) < std::pair(middle(g), g);
        });
        boxes_[b].left = static_cast<int>(boxes_.size());
        boxes_.push_back(boxAround(box.first, half));
        boxes_[b].right = static_cast<int>(boxes_.size());
        boxes_.push_back(boxAround(box.first + half, box.count - half));
    }
}

SurfacePoint NearestSurface::find(const Eigen::Vector3d& p) const {
    SurfacePoint best{0, {1, 0, 0}};  // of a point so far away that no distance is a number
    double least = std::numeric_limits<double>::infinity();
    std::vector<int> open{0};
    while (!open.empty()) {
        const Box& box = boxes_[open.back()];
        open.pop_back();
        if (box.squaredDistance(p) > least) {
            continue;
        }
        if (box.left < 0) {
            for (int i = box.first; i < box.first + box.count; ++i) {
                const int f = order_[i];
                const SurfacePoint point{
                    f, nearestInTriangle(p, mesh_.V.row(mesh_.F(f, 0)), mesh_.V.row(mesh_.F(f, 1)),
                                         mesh_.V.row(mesh_.F(f, 2)))};
                const double distance = (positionOf(mesh_, point) - p).squaredNorm();
                if (distance < least || (distance == least && f < best.face)) {
                    least = distance;
                    best = point;
                }
            }
            continue;
        }
        const bool leftFirst =
            boxes_[box.left].squaredDistance(p) <= boxes_[box.right].squaredDistance(p);
        open.push_back(leftFirst ? box.right : box.left);
        open.push_back(leftFirst ? box.left : box.right);
    }
    return best;
}

}  // namespace toile
