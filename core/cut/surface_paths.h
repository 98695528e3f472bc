// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/cut/surface_point.h"
#include "core/geometry/buckets.h"
#include "core/geometry/shortest_paths.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The element that a surface point lies on.
struct Carrier {
    enum class Kind { Vertex, Edge, Face };
    Kind kind;
    int index;  ///< of the vertex, the edge or the face

    bool operator==(const Carrier&) const = default;
};

/// Moves from triangle to triangle and around vertices. Keeps references: the mesh and its table
/// must outlive it. A *use* is 3 * face + k, the side from corner k to corner k + 1. An edge that
/// does not join exactly two triangles of the same winding is a wall. Immutable, so shareable.
class SurfaceLinks {
public:
    SurfaceLinks(const MeshArrays& mesh, const EdgeTable& table);

    const MeshArrays& mesh() const { return mesh_; }
    const EdgeTable& table() const { return table_; }
    int vertexCount() const { return static_cast<int>(mesh_.V.rows()); }
    int faceCount() const { return static_cast<int>(mesh_.F.rows()); }
    int edgeCount() const { return static_cast<int>(table_.edges.rows()); }

    int tail(int use) const { return tailOf(mesh_.F, use); }
    int head(int use) const { return headOf(mesh_.F, use); }
    int edgeOf(int use) const { return table_.faceEdges(use / 3, use % 3); }
    /// The same edge as used by the other triangle, or -1 at a wall.
    int twin(int use) const { return twin_[use]; }
    /// Corners 3 * face + k at the vertex, in face order.
    std::span<const int> cornersAt(int vertex) const { return corners_[vertex]; }
    /// Corner of `face` at `vertex`, 0..2, or -1.
    int cornerIn(int face, int vertex) const;
    /// Interior angle of the triangle at a corner.
    double angleAt(int corner) const;
    /// True if every triangle around the vertex has a neighbour on both sides.
    bool isInner(int vertex) const;
    double angleAround(int vertex) const;
    /// Angle by which the surface bends at an edge, in [0, pi]; 0 if no two triangles meet.
    double foldAngle(int edge) const;

    Carrier carrierOf(const SurfacePoint& point) const;
    std::vector<int> facesOf(const Carrier& carrier) const;
    /// The same point with weights for another triangle, or nothing if it does not touch it.
    std::optional<SurfacePoint> seenFrom(int face, const SurfacePoint& point) const;
    /// A triangle that both points touch, `preferred` if possible; -1 if there is none.
    int commonFace(const SurfacePoint& a, const SurfacePoint& b, int preferred = -1) const;

    /// Precondition: the vertex belongs to a triangle.
    SurfacePoint atVertex(int vertex) const;
    /// @param t  0 at the edge's first vertex in the table, 1 at its second
    SurfacePoint onEdge(int edge, double t) const;

private:
    const MeshArrays& mesh_;
    const EdgeTable& table_;
    std::vector<int> twin_;
    geometry::Buckets<> corners_;  ///< by vertex
};

/// Lengths of all edges.
std::vector<double> edgeLengths(const MeshArrays& mesh, const Edges& edges);

/// The shortest path along edges from one vertex to another. Ties are decided by index, so that the
/// same mesh gives the same path. If both vertices are equal it has no length.
/// @param progress  polled during the search, nothing is reported
/// @errors  a cut error if the vertices are not connected; Cancelled
/// Cost: linear, plus O(n log n) in the edges closer to `from` than the path is long. Re-entrant.
Result<PathPolyline> edgePath(const SurfaceLinks& links, int from, int to,
                              const Progress& progress = Progress());

/// A path of vertices as surface points. Precondition: neighbours share an edge.
PathPolyline polylineOf(const SurfaceLinks& links, const std::vector<int>& vertices);

/// Positions in space of a path's points. Cost: linear. Pure.
std::vector<Eigen::Vector3d> positionsOf(const MeshArrays& mesh, const PathPolyline& path);

/// Short paths across the surface, through the insides of triangles: A* on a graph of vertices and
/// points on edges (after [Lan99]) decides on which side to pass each bump, then the path is pulled
/// tight (see straightened). Locally shortest, and never longer than the path along edges; probably
/// the shortest, but not guaranteed. May run along a rim.
/// @return  points from `from` to `to`; a single one twice if both are equal
/// @param progress  polled while the graph is searched, nothing is reported
/// @errors  a cut error if the points are not connected; Cancelled
/// Cost: O(n log n) in the triangles closer to `from` than the path is long. Re-entrant.
Result<PathPolyline> geodesicPath(const SurfaceLinks& links, const SurfacePoint& from,
                                  const SurfacePoint& to, const Progress& progress = Progress());

}  // namespace toile
