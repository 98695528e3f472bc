// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/weld.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/statistics.h"
#include "core/base/wording.h"
#include "core/geometry/point_index.h"

namespace toile {
namespace {

/// Relative to the median edge: more than the last digit in mesh files, less than any cut cloth.
constexpr double kToleranceOfMedianEdge = 1e-3;
/// A file has loose faces if this share of its used vertices belong to one face, and the second
/// share of them lie on an earlier one (five of six in a closed mesh of loose triangles).
constexpr double kLooseShare = 0.95;
constexpr double kCoincidentShare = 1.0 / 3;

std::vector<char> borderVertices(const Triangles& F, Eigen::Index vertexCount) {
    std::vector<char> border(vertexCount, 0);
    const EdgeTable table = buildEdgeTable(F, static_cast<int>(vertexCount));
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (table.usesOf(e).size() != 2) {
            border[table.edges(e, 0)] = 1;
            border[table.edges(e, 1)] = 1;
        }
    }
    return border;
}

}  // namespace

Weld findWeld(const Triangles& F, const PointsView& V, const WeldOptions& options) {
    const int vertexCount = static_cast<int>(V.rows());
    const std::vector<char> takesPart =
        options.borderOnly ? borderVertices(F, vertexCount) : usedVertices(F, vertexCount);
    std::vector<Eigen::Vector3d> places;
    std::vector<int> vertexAt;  // per place: the first vertex there
    geometry::PointIndex index(places, options.tolerance);
    Weld weld;
    weld.target.resize(vertexCount);
    for (int v = 0; v < vertexCount; ++v) {
        weld.target[v] = v;
        if (takesPart[v] == 0 || !V.row(v).allFinite()) {
            continue;
        }
        const auto [place, isNew] = index.insert(V.row(v));
        if (isNew) {
            vertexAt.push_back(v);
        } else {
            weld.target[v] = vertexAt[place];
            ++weld.merged;
        }
    }
    return weld;
}

Error weldNote(const Weld& weld, const PointsView& V, const std::string& name) {
    int first = 0;
    while (weld.target[first] == first) {
        ++first;
    }
    const std::vector<Wording> words{countWording(weld.merged, "vertex"),
                                     barePlaceWording(V(first, 0), V(first, 1), V(first, 2))};
    return {ErrorCode::VerticesWelded, Subject::file(name),
            weld.merged == 1 ? worded("%1 welded to another, at %2 mm", words)
                             : worded("%1 welded to another, the first at %2 mm", words)};
}

double weldTolerance(const Triangles& F, const PointsView& V) {
    std::vector<double> lengths;
    lengths.reserve(F.size());
    for (int f = 0; f < F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const double length = (V.row(F(f, (k + 1) % 3)) - V.row(F(f, k))).norm();
            if (std::isfinite(length)) {
                lengths.push_back(length);
            }
        }
    }
    return kToleranceOfMedianEdge * medianOf(std::move(lengths));
}

bool looksUnwelded(const Triangles& F, const PointsView& V) {
    std::vector<int> uses(V.rows(), 0);
    for (Eigen::Index corner = 0; corner < F.size(); ++corner) {
        ++uses[F.data()[corner]];
    }
    const auto used =
        static_cast<double>(std::ssize(uses) - std::count(uses.begin(), uses.end(), 0));
    const auto loose =
        std::count_if(uses.begin(), uses.end(), [](int n) { return n == 1 || n == 2; });
    return F.rows() > 1 && static_cast<double>(loose) >= kLooseShare * used &&
           findWeld(F, V, {}).merged >= kCoincidentShare * used;
}

}  // namespace toile
