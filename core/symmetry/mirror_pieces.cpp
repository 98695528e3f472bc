// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/mirror_pieces.h"

#include <cmath>
#include <map>
#include <memory>

#include "core/cut/surface_point.h"
#include "core/geometry/buckets.h"
#include "core/symmetry/garment_surface.h"

namespace toile {
namespace {

using symmetry::GarmentSurface;

constexpr int kSamplesOfPieces = 20000;

/// The sampled vertices of each piece.
geometry::Buckets<> samplesByPiece(const GarmentSurface& surface, int pieceCount) {
    const std::vector<int> vertices = surface.sampled(kSamplesOfPieces);
    return {pieceCount, [&](const auto& add) {
                for (const int v : vertices) {
                    add(surface.pieceOfVertex[v], v);
                }
            }};
}

/// Per piece: where most of its area lies once reflected, the least index of ties; -1 without area.
std::vector<int> majorities(const GarmentSurface& surface, const geometry::Buckets<>& samples,
                            const MirrorPlane& plane, const Progress& progress) {
    const NearestSurface nearest(surface.mesh);
    std::vector<int> most(static_cast<std::size_t>(samples.keyCount()), -1);
    for (int p = 0; p < samples.keyCount(); ++p) {
        std::map<int, double> areas;
        for (const int v : samples[p]) {
            if (progress.isCancelled()) {
                return most;
            }
            const Eigen::Vector3d image = plane.reflected(surface.mesh.V.row(v));
            areas[surface.pieceOfFace[nearest.find(image).face]] += surface.area[v];
        }
        double largest = 0;
        for (const auto& [piece, area] : areas) {
            if (area > largest) {
                largest = area;
                most[p] = piece;
            }
        }
    }
    return most;
}

/// Sums over the reflected samples of a piece: squared distance to another piece, and weight.
Eigen::Vector2d distancesTo(const NearestSurface& nearest, const MeshArrays& there,
                            std::span<const int> samples, const GarmentSurface& surface,
                            const MirrorPlane& plane) {
    Eigen::Vector2d sums(0, 0);
    for (const int v : samples) {
        const Eigen::Vector3d image = plane.reflected(surface.mesh.V.row(v));
        const Eigen::Vector3d point = positionOf(there, nearest.find(image));
        sums += surface.area[v] * Eigen::Vector2d((point - image).squaredNorm(), 1);
    }
    return sums;
}

}  // namespace

MirrorPieces pairPieces(const Garment& garment, const MirrorPlane& plane,
                        const Progress& progress) {
    const auto count = static_cast<int>(garment.pieces.size());
    MirrorPieces none{std::vector<int>(garment.pieces.size(), -1),
                      std::vector<double>(garment.pieces.size(), 0)};
    const GarmentSurface surface = symmetry::surfaceOf(garment.pieces);
    if (surface.mesh.F.rows() == 0) {
        return none;
    }
    MirrorPieces pairs = none;
    const geometry::Buckets<> samples = samplesByPiece(surface, count);
    const std::vector<int> most = majorities(surface, samples, plane, progress);
    std::vector<Eigen::Vector2d> sums(garment.pieces.size(), Eigen::Vector2d::Zero());
    for (int p = 0; p < count; ++p) {
        if (progress.isCancelled()) {
            return none;
        }
        const int q = most[p];
        if (q < 0 || most[q] != p) {
            continue;
        }
        pairs.counterpart[p] = q;
        const MeshArrays& there = garment.pieces[q]->mesh;
        sums[p] = distancesTo(NearestSurface(there), there, samples[p], surface, plane);
    }
    for (int p = 0; p < count; ++p) {
        if (const int q = pairs.counterpart[p]; q >= 0) {
            const Eigen::Vector2d both = sums[std::min(p, q)] + sums[std::max(p, q)];
            pairs.deviation[p] = std::sqrt(both.x() / both.y());
        }
    }
    return pairs;
}

}  // namespace toile
