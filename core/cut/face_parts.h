// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/cut/surface_paths.h"

namespace toile {

/// The triangles of a mesh, each with the parts it has been split into. A new vertex is stored by
/// its weights in a triangle or along an edge of the source, so that positions never drift and
/// points on an edge stay there exactly. A copy costs a few numbers for each triangle of the mesh;
/// keep one to be able to undo a path.
class FaceParts {
public:
    using Part = std::array<int, 3>;         ///< vertex numbers, winding as in the source
    using VertexPair = std::pair<int, int>;  ///< the smaller number first

    explicit FaceParts(const SurfaceLinks& links);

    const SurfaceLinks& links() const { return *links_; }

    /// Vertices of the source keep their indices, new ones follow.
    int vertexCount() const { return links().vertexCount() + static_cast<int>(places_.size()); }

    SurfacePoint placeOf(int vertex) const;
    /// Parts of a source triangle, or itself if it was not split. Valid until the next split.
    std::span<const Part> partsOf(int face) const;
    /// Whether this source triangle, or all together, have more parts than any garment needs.
    bool isCrowded(int face) const;
    /// Weights in a source triangle that the vertex touches; zeros are exact.
    Eigen::Vector3d weightsIn(int face, int vertex) const;

    /// Splits an edge of the parts of `face`, on both sides. @return the new vertex
    int splitEdge(int face, int a, int b, double t);
    /// Splits a part into three. @param local  weights in the part, all positive
    int splitPart(int face, std::size_t part, const Eigen::Vector3d& local);

    /// The vertex at a point of a path, so that paths through the same point meet there even after
    /// splits around it; -1 if it is new.
    int vertexAt(const SurfacePoint& point) const;
    void remember(const SurfacePoint& point, int vertex);

    /// The current vertices of a path: split edges are replaced by their halves.
    std::vector<int> refined(const std::vector<int>& path) const;

    /// Flips diagonals inside each split triangle towards the Delaunay triangulation of its parts,
    /// which has the fewest slivers; `kept` edges stay. Adds no vertex and keeps the area. If
    /// cancelled, it stops early.
    void relax(const std::set<VertexPair>& kept, const Progress& progress);

private:
    /// The place of a new vertex: on an edge of the source, or inside a triangle.
    struct Place {
        int edge;                 ///< -1 where inside
        int face;                 ///< -1 where on an edge
        Eigen::Vector3d weights;  ///< in the face; on an edge: 1 - t, t, unused
    };

    std::vector<Part>& parts(int face);
    int sharedSide(int face, int a, int b) const;
    /// @param uses  number of parts of the face that have it as a side
    void replaceEdge(int face, int a, int b, int middle, int uses);
    void relaxFace(int face, std::vector<Part>& list, const std::set<VertexPair>& kept) const;

    const SurfaceLinks* links_;
    std::vector<Part> whole_;  ///< the source triangles
    std::vector<int> slot_;    ///< per source triangle: index into split_, or -1
    std::vector<std::vector<Part>> split_;
    std::vector<int> splitFace_;                     ///< source triangle of each entry of split_
    std::vector<Place> places_;                      ///< of new vertices
    std::map<VertexPair, int> middle_;               ///< of edges that were split
    std::map<std::array<double, 4>, int> vertexAt_;  ///< by face and weights
};

/// Turns curves into edges of the parts of triangles. Decides on an equilateral reference triangle,
/// so that the shape of the source does not matter and parts never overlap. A point closer to a
/// vertex or an edge of a part than a fiftieth of its size snaps to it, so that slivers are rare.
/// Vertices never move; the cut does, by that distance.
class FaceSplitter {
public:
    explicit FaceSplitter(FaceParts& parts) : parts_(parts) {}

    /// The vertex at a point, new if no other is close; touches all triangles of the point.
    int insert(const SurfacePoint& point);

    /// Makes edges from vertex `from` to vertex `to`, straight across the source triangle `face`
    /// that both touch. Appends the vertices passed to `path`, `to` included. False if it does not
    /// arrive, which would be a bug.
    bool connect(int face, int from, int to, std::vector<int>& path);

private:
    int insertNew(const SurfacePoint& point);
    int step(int face, int from, int to);

    FaceParts& parts_;
};

}  // namespace toile
