// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/base/progress.h"
#include "core/cut/surface_paths.h"
#include "core/geometry/shortest_paths.h"
#include "core/tailor/garment_body.h"

namespace toile {

/// Cheapest paths along the edges of a garment, by costs for tailors' lines. Keeps references:
/// links, body and progress must outlive it. After a cancel, paths are empty or short.
class BodyWays {
public:
    /// Cost: linear in the triangles, and some rounds of smoothing their normals.
    BodyWays(const SurfaceLinks& links, const GarmentBody& body, const Progress& progress);

    bool isCancelled() const { return progress_.isCancelled(); }

    const SurfaceLinks& links() const { return links_; }
    const GarmentBody& body() const { return body_; }

    Eigen::Vector3d at(int vertex) const { return links_.mesh().V.row(vertex).transpose(); }
    double across(int vertex) const { return body_.across(at(vertex)); }
    double height(int vertex) const { return body_.height(at(vertex)); }
    /// Front view: distance from the mirror plane, outward on that side, and height, mm.
    Eigen::Vector2d seen(int vertex, int side = 1) const {
        return {side * across(vertex), height(vertex)};
    }
    /// How far the cloth faces ahead there: 1 ahead, -1 back, 0 on the silhouette.
    double facing(int vertex) const { return facing_[vertex]; }

    const std::vector<double>& lengths() const { return lengths_; }  ///< of edges, mm
    double length(const std::vector<int>& way) const;
    /// Length of each edge times the mean of a factor at its two ends.
    std::vector<double> costs(const std::function<double(int)>& factorAt) const;
    /// Low costs along the silhouette, where front meets back.
    const std::vector<double>& silhouette() const { return silhouette_; }

    /// The same for a flared trunk that hangs in folds: low costs where the garment is widest at
    /// each height.
    std::vector<double> envelope() const;

    /// The cheapest path from any of some vertices to any of others; empty if there is none. Cost:
    /// O(#E log #E).
    /// @param costs  of edges, not negative
    std::vector<int> cheapest(const std::vector<double>& costs, const std::vector<int>& from,
                              const std::vector<int>& to) const;
    /// The cheapest paths from one vertex to all others.
    geometry::ShortestForest waysFrom(int vertex, const std::vector<double>& costs) const;

private:
    const SurfaceLinks& links_;
    const GarmentBody& body_;
    const Progress& progress_;
    std::vector<double> lengths_, facing_, silhouette_;
};

}  // namespace toile
