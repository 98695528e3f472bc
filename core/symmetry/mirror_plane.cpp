// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/symmetry/mirror_plane.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/base/statistics.h"
#include "core/cut/nearest_search.h"
#include "core/quality/measures.h"

namespace toile::symmetry {
namespace {

/// Appends the arrays of all pieces.
void appendPieces(const Pieces& pieces, GarmentSurface& surface) {
    Eigen::Index vertices = 0, faces = 0;
    for (const auto& piece : pieces) {
        vertices += piece->mesh.V.rows();
        faces += piece->mesh.F.rows();
    }
    surface.mesh.V.resize(vertices, 3);
    surface.mesh.F.resize(faces, 3);
    Eigen::Index v = 0, f = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const MeshArrays& mesh = pieces[p]->mesh;
        surface.mesh.V.middleRows(v, mesh.V.rows()) = mesh.V;
        surface.mesh.F.middleRows(f, mesh.F.rows()) = mesh.F.array() + static_cast<int>(v);
        v += mesh.V.rows();
        f += mesh.F.rows();
        surface.pieceOfVertex.resize(static_cast<std::size_t>(v), static_cast<int>(p));
        surface.pieceOfFace.resize(static_cast<std::size_t>(f), static_cast<int>(p));
    }
}

void weigh(GarmentSurface& surface) {
    const MeshArrays& mesh = surface.mesh;
    const Eigen::VectorXd areas = triangleAreas3d(mesh);
    surface.area = Eigen::VectorXd::Zero(mesh.V.rows());
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            surface.area[mesh.F(f, k)] += areas[f] / 3;
        }
    }
    const double sum = surface.area.sum();
    if (!(sum > 0)) {
        return;
    }
    surface.centre = mesh.V.transpose() * surface.area / sum;
    const Points3 centred = mesh.V.rowwise() - surface.centre.transpose();
    surface.spread = centred.transpose() * surface.area.asDiagonal() * centred / sum;
}

}  // namespace

double GarmentSurface::radius() const {
    return std::sqrt(spread.trace());
}

std::vector<int> GarmentSurface::sampled(int most) const {
    const auto count = static_cast<int>(mesh.V.rows());
    const int step = std::max(1, (count + most - 1) / most);
    std::vector<int> vertices;
    for (int v = 0; v < count; v += step) {
        vertices.push_back(v);
    }
    return vertices;
}

GarmentSurface surfaceOf(const Pieces& pieces) {
    GarmentSurface surface;
    appendPieces(pieces, surface);
    weigh(surface);
    return surface;
}

}  // namespace toile::symmetry

namespace toile {
namespace {

using symmetry::GarmentSurface;

constexpr int kRounds = 40;
/// Numbers of vertices to choose among the axes, to find the plane, and to measure it.
constexpr int kFew = 500, kMany = 1500, kMost = 20000;
constexpr double kMediansKept = 3;
/// A plane that moves by less than this fraction of the garment's size has converged.
constexpr double kAtRest = 1e-8;
/// Axes with a larger cosine between them lead to the same plane.
constexpr double kSameAxis = 0.97;

/// The plane with a given normal through a point.
MirrorPlane planeThrough(const Eigen::Vector3d& point, const Eigen::Vector3d& direction) {
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    MirrorPlane plane;
    plane.normal = direction.normalized() * (direction[largest] < 0 ? -1 : 1);
    plane.offset = plane.normal.dot(point);
    return plane;
}

/// Vertices, and the nearest surface points to their reflections.
struct ReflectedPairs {
    Points3 from, to;
    Eigen::VectorXd distance, weight;
};

void leaveOutFarPairs(ReflectedPairs& pairs) {
    const double most =
        kMediansKept * medianOf(std::vector(pairs.distance.begin(), pairs.distance.end()));
    pairs.weight = (pairs.distance.array() <= most).select(pairs.weight, 0.0);
}

/// The plane whose reflection fits the pairs best.
MirrorPlane bestPlane(const ReflectedPairs& pairs) {
    const double sum = pairs.weight.sum();
    const Eigen::RowVector3d meanFrom = pairs.weight.transpose() * pairs.from / sum;
    const Eigen::RowVector3d meanTo = pairs.weight.transpose() * pairs.to / sum;
    const Points3 from = pairs.from.rowwise() - meanFrom, to = pairs.to.rowwise() - meanTo;
    const Eigen::Matrix3d product = from.transpose() * pairs.weight.asDiagonal() * to / sum;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(product + product.transpose());
    return planeThrough(0.5 * (meanFrom + meanTo).transpose(), eigen.eigenvectors().col(0));
}

class PlaneSearch {
public:
    PlaneSearch(const GarmentSurface& surface, const Progress& progress)
        : surface_(surface),
          tree_(treeOf(surface.mesh)),
          radius_(surface.radius()),
          progress_(progress) {}

    /// The converged plane, or that of the last round.
    MirrorPlane improved(MirrorPlane plane, int most) const {
        const std::vector<int> vertices = surface_.sampled(most);
        std::vector<int> faces(vertices.size(), -1);
        for (int round = 0; round < kRounds && !progress_.isCancelled(); ++round) {
            ReflectedPairs pairs = pairsOf(vertices, plane, faces);
            leaveOutFarPairs(pairs);
            if (!(pairs.weight.sum() > 0)) {
                break;
            }
            const MirrorPlane next = bestPlane(pairs);
            const double moved = movement(plane, next);
            plane = next;
            if (moved <= kAtRest) {
                break;
            }
        }
        return plane;
    }

    /// The plane with its deviation.
    MirrorPlane measured(MirrorPlane plane, int most) const {
        const std::vector<int> vertices = surface_.sampled(most);
        std::vector<int> faces(vertices.size(), -1);
        const ReflectedPairs pairs = pairsOf(vertices, plane, faces);
        const double square = pairs.weight.dot(pairs.distance.cwiseAbs2()) / pairs.weight.sum();
        plane.deviation = std::sqrt(square);
        plane.farthest = pairs.distance.maxCoeff();
        return plane;
    }

private:
    /// @param faces  faces of the nearest points in the round before, or -1; updated by this round
    ReflectedPairs pairsOf(const std::vector<int>& vertices, const MirrorPlane& plane,
                           std::vector<int>& faces) const {
        const auto count = static_cast<Eigen::Index>(vertices.size());
        ReflectedPairs pairs{Points3::Zero(count, 3), Points3::Zero(count, 3),
                             Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count)};
        for (Eigen::Index i = 0; i < count && !progress_.isCancelled(); ++i) {
            const int v = vertices[static_cast<std::size_t>(i)];
            const Eigen::Vector3d image = plane.reflected(surface_.mesh.V.row(v));
            int& face = faces[static_cast<std::size_t>(i)];
            const SurfacePoint nearest = nearestOn(surface_.mesh, tree_, image, face);
            face = nearest.face;
            const Eigen::Vector3d there = positionOf(surface_.mesh, nearest);
            pairs.from.row(i) = surface_.mesh.V.row(v);
            pairs.to.row(i) = there;
            pairs.distance[i] = (there - image).norm();
            pairs.weight[i] = surface_.area[v];
        }
        return pairs;
    }

    /// Distance between two planes at the garment, as a fraction of its size.
    double movement(const MirrorPlane& a, const MirrorPlane& b) const {
        const double turn = std::min((a.normal - b.normal).norm(), (a.normal + b.normal).norm());
        const double atCentre = std::abs(a.normal.dot(surface_.centre) - a.offset) -
                                std::abs(b.normal.dot(surface_.centre) - b.offset);
        return turn + std::abs(atCentre) / radius_;
    }

    const GarmentSurface& surface_;
    geometry::TriangleTree<3, double> tree_;
    double radius_;
    const Progress& progress_;
};

/// Root mean square distance of the area from a plane, mm.
double widthAcross(const MirrorPlane& plane, const GarmentSurface& surface) {
    const double beside = plane.normal.dot(surface.centre) - plane.offset;
    const double square = plane.normal.dot(surface.spread * plane.normal) + beside * beside;
    return std::sqrt(std::max(0.0, square));
}

/// Principal axes of the area, and the coordinate axes that differ from them.
std::vector<Eigen::Vector3d> axesOf(const GarmentSurface& surface) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(surface.spread);
    std::vector<Eigen::Vector3d> axes;
    axes.reserve(6);
    for (int k = 0; k < 3; ++k) {
        axes.emplace_back(eigen.eigenvectors().col(k));
    }
    for (int k = 0; k < 3; ++k) {
        if (eigen.eigenvectors().row(k).cwiseAbs().maxCoeff() < kSameAxis) {
            axes.emplace_back(Eigen::Vector3d::Unit(k));
        }
    }
    return axes;
}

}  // namespace

std::optional<MirrorPlane> findMirrorPlane(const Pieces& pieces, const Progress& progress) {
    const GarmentSurface surface = symmetry::surfaceOf(pieces);
    if (!(surface.radius() > 0)) {
        return std::nullopt;
    }
    const PlaneSearch search(surface, progress);
    std::optional<MirrorPlane> best;
    for (const Eigen::Vector3d& axis : axesOf(surface)) {
        const MirrorPlane start = planeThrough(surface.centre, axis);
        const MirrorPlane plane = search.measured(search.improved(start, kFew), kMany);
        if (widthAcross(plane, surface) >= kMinMirrorWidth * surface.radius() &&
            (!best || plane.deviation < best->deviation)) {
            best = plane;
        }
    }
    if (!best || progress.isCancelled()) {
        return std::nullopt;
    }
    best = search.measured(search.improved(*best, kMany), kMost);
    return !progress.isCancelled() && best->deviation <= kMaxMirrorDeviation * surface.radius()
               ? best
               : std::nullopt;
}

}  // namespace toile
