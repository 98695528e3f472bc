// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/cut_along.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "core/cut/face_parts.h"
#include "core/mesh/tri_mesh.h"

namespace toile {
namespace {

std::optional<Error> whyNotCuttable(const SurfaceLinks& links) {
    for (int e = 0; e < links.edgeCount(); ++e) {
        const std::span<const int> uses = links.table().usesOf(e);
        if (uses.size() > 2) {
            return Error{ErrorCode::NonManifoldEdge};
        }
        if (uses.size() == 2 && links.twin(uses[0]) < 0) {
            return Error{ErrorCode::OpposedWinding};
        }
    }
    return std::nullopt;
}

/// Inserts a path into the mesh and returns its vertices.
Result<std::vector<int>> embed(FaceParts& parts, const PathPolyline& path,
                               const Progress& progress) {
    const SurfaceLinks& links = parts.links();
    FaceSplitter splitter(parts);
    std::vector<int> vertices;
    int face = -1;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        const SurfacePoint& point = path.points[i];
        const int vertex = splitter.insert(point);
        if (i == 0) {
            vertices.push_back(vertex);
            continue;
        }
        face = links.commonFace(path.points[i - 1], point, face);
        if (face < 0) {
            return cutError({}, worded("points %1 and %2 of a path share no triangle",
                                       {figure(double(i)), figure(double(i + 1))}));
        }
        if (!splitter.connect(face, vertices.back(), vertex, vertices)) {
            return cutError({}, worded("a path could not be continued through a triangle"));
        }
        if (parts.isCrowded(face)) {
            return cutError({}, worded("it crosses itself and earlier cuts so often that a "
                                       "triangle would split into thousands of parts"));
        }
    }
    return vertices;
}

/// The current edges of all paths.
std::set<FaceParts::VertexPair> edgesOf(const FaceParts& parts,
                                        const std::vector<std::vector<int>>& ways) {
    std::set<FaceParts::VertexPair> edges;
    for (const auto& way : ways) {
        const std::vector<int> path = parts.refined(way);
        for (std::size_t i = 1; i < path.size(); ++i) {
            edges.insert(std::minmax(path[i - 1], path[i]));
        }
    }
    return edges;
}

/// The mesh made of all parts.
MeshArrays assemble(const FaceParts& parts, std::vector<int>& sourceFace) {
    const SurfaceLinks& links = parts.links();
    const MeshArrays& source = links.mesh();
    MeshArrays mesh;
    mesh.V.resize(parts.vertexCount(), 3);
    mesh.V.topRows(source.V.rows()) = source.V;
    for (int v = links.vertexCount(); v < parts.vertexCount(); ++v) {
        mesh.V.row(v) = positionOf(source, parts.placeOf(v));
    }
    std::vector<FaceParts::Part> faces;
    sourceFace.clear();
    for (int f = 0; f < links.faceCount(); ++f) {
        const auto list = parts.partsOf(f);
        faces.insert(faces.end(), list.begin(), list.end());
        sourceFace.resize(faces.size(), f);
    }
    mesh.F.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        mesh.F.row(static_cast<Eigen::Index>(f)) << faces[f][0], faces[f][1], faces[f][2];
    }
    return mesh;
}

/// A cut edge whose two sides still share both ends: it needs a vertex in between.
struct ShutEdge {
    int from, to;
    int face;  ///< the first of the two at this edge
};

/// A mesh separated along edges.
struct OpenedMesh {
    MeshArrays mesh;
    std::vector<int> copyOf;  ///< per vertex beyond those of the input: the one that it copies
    std::vector<OpenedCut> cuts;
    std::vector<ShutEdge> stillShut;
};

/// Separates a mesh along paths of vertices, neighbours joined by an edge. Every vertex is divided
/// into as many copies as the cuts divide the triangles around it into groups; the first keeps its
/// index. Rim edges and edges cut by an earlier path are skipped. Cost: linear.
class Opener {
public:
    /// @param result  with the mesh
    Opener(OpenedMesh& result, const std::vector<std::vector<int>>& paths)
        : result_(result),
          table_(buildEdgeTable(result.mesh.F, static_cast<int>(result.mesh.V.rows()))),
          mesh_(buildTriMesh(result.mesh, table_)),
          isTouched_(mesh_->n_vertices(), 0) {
        for (int e = 0; e < table_.edges.rows(); ++e) {
            isOpen_.push_back(table_.isBorder(e) ? 1 : 0);
        }
        for (const std::vector<int>& path : paths) {
            steps_.push_back(collect(path));
        }
    }

    void run() {
        partVertices();
        for (const auto& steps : steps_) {
            result_.cuts.push_back(follow(steps));
        }
    }

private:
    using Vertex = TriMesh::VertexHandle;
    using Halfedge = OpenMesh::SmartHalfedgeHandle;

    /// The half-edges along a path; invalid ones along a rim or an earlier cut.
    std::vector<Halfedge> collect(const std::vector<int>& path) {
        std::vector<Halfedge> steps;
        for (std::size_t i = 1; i < path.size(); ++i) {
            const int e = findEdge(table_.edges, path[i - 1], path[i]);
            const bool opens = e >= 0 && std::exchange(isOpen_[e], 1) == 0;
            isTouched_[path[i]] |= opens ? 1 : 0;
            isTouched_[path[i - 1]] |= opens ? 1 : 0;
            const int along = path[i - 1] < path[i] ? 2 * e : 2 * e + 1;
            steps.emplace_back(opens ? along : -1, mesh_.get());
        }
        return steps;
    }

    /// Then the half-edges of either side of a cut point to the copies on that side.
    void partVertices() {
        MeshArrays& mesh = result_.mesh;
        const auto sourceCount = static_cast<int>(mesh.V.rows());
        std::vector<char> isTaken(isTouched_.size(), 0), isDone(mesh_->n_halfedges(), 0);
        for (int corner = 0; corner < mesh.F.size(); ++corner) {
            int& v = mesh.F.data()[corner];
            if (isTouched_[v] == 0) {
                continue;
            }
            const int side = previousSide(corner), e = table_.faceEdges.data()[side];
            const Halfedge into(table_.edges(e, 1) == v ? 2 * e : 2 * e + 1, mesh_.get());
            if (isDone[into.idx()] == 0) {
                Vertex own(v);
                if (std::exchange(isTaken[v], 1) != 0) {
                    own = Vertex(sourceCount + static_cast<int>(result_.copyOf.size()));
                    result_.copyOf.push_back(v);
                }
                giveFan(into, own, isDone);
            }
            v = into.to().idx();
        }
        mesh.V.conservativeResize(sourceCount + std::ssize(result_.copyOf), 3);
        for (int k = 0; k < std::ssize(result_.copyOf); ++k) {
            mesh.V.row(sourceCount + k) = mesh.V.row(result_.copyOf[k]);
        }
    }

    /// Assigns a vertex to a corner and to all others joined to it by closed edges.
    void giveFan(Halfedge corner, Vertex own, std::vector<char>& isDone) {
        Halfedge at = corner;
        while (isOpen_[at.edge().idx()] == 0 && at.opp().prev() != corner) {
            at = at.opp().prev();
        }
        while (std::exchange(isDone[at.idx()], 1) == 0) {
            mesh_->set_vertex_handle(at, own);
            at = isOpen_[at.next().edge().idx()] == 0 ? at.next().opp() : at;
        }
    }

    OpenedCut follow(const std::vector<Halfedge>& steps) {
        OpenedCut cut;
        bool goesOn = false;
        for (const Halfedge left : steps) {
            if (!left.is_valid()) {
                goesOn = false;
                continue;
            }
            const Halfedge right = left.opp();
            const int leftFrom = left.prev().to().idx(), leftTo = left.to().idx();
            const int rightFrom = right.to().idx(), rightTo = right.prev().to().idx();
            if (!goesOn || cut.runs.back().left.back() != leftFrom ||
                cut.runs.back().right.back() != rightFrom) {
                cut.runs.push_back({{leftFrom}, {rightFrom}, 0});
                goesOn = true;
            }
            CutRun& run = cut.runs.back();
            const double length =
                (result_.mesh.V.row(leftTo) - result_.mesh.V.row(leftFrom)).norm();
            run.left.push_back(leftTo);
            run.right.push_back(rightTo);
            run.length += length;
            cut.length += length;
            if (leftFrom == rightFrom && leftTo == rightTo) {
                const auto ends = table_.edges.row(left.edge().idx());
                result_.stillShut.push_back(
                    {ends[0], ends[1], std::min(left.face().idx(), right.face().idx())});
            }
        }
        return cut;
    }

    OpenedMesh& result_;
    const EdgeTable table_;
    const std::unique_ptr<TriMesh> mesh_;
    std::vector<char> isTouched_;  ///< per vertex: a cut ends or passes there
    std::vector<char> isOpen_;     ///< per edge: at a rim, or cut
    std::vector<std::vector<Halfedge>> steps_;
};

}  // namespace

Result<CutResult> cutAlong(const MeshArrays& mesh, const std::vector<PathPolyline>& paths,
                           const CutOptions& options, const Progress& progress) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    if (auto error = whyNotCuttable(links)) {
        return *error;
    }
    FaceParts parts(links);
    std::vector<std::vector<int>> ways;
    std::vector<std::optional<Error>> errors;
    for (const PathPolyline& path : paths) {
        std::optional<FaceParts> before;  // to undo the path if it fails
        if (options.leavesOut) {
            before = parts;
        }
        auto way = embed(parts, path, progress);
        if (!way && (!before || progress.isCancelled())) {
            return way.error();
        }
        if (!way) {
            parts = *std::move(before);
        }
        errors.push_back(way ? std::nullopt : std::optional(way.error()));
        ways.push_back(way ? std::move(*way) : std::vector<int>{});
    }
    parts.relax(edgesOf(parts, ways), progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    CutResult result;
    const auto open = [&] {
        std::vector<std::vector<int>> refined;
        refined.reserve(ways.size());
        for (const auto& way : ways) {
            refined.push_back(parts.refined(way));
        }
        OpenedMesh made{assemble(parts, result.sourceFace), {}, {}, {}};
        Opener(made, refined).run();
        return made;
    };
    OpenedMesh opened = open();
    if (!opened.stillShut.empty()) {
        // A new vertex is surrounded by the cut alone, so that it separates: once is enough.
        for (const ShutEdge& edge : opened.stillShut) {
            parts.splitEdge(result.sourceFace[edge.face], edge.from, edge.to, 0.5);
        }
        opened = open();
    }
    result.mesh = std::move(opened.mesh);
    result.cuts = std::move(opened.cuts);
    for (std::size_t c = 0; c < errors.size(); ++c) {
        result.cuts[c].error = std::move(errors[c]);
    }
    const int embedded = parts.vertexCount();
    for (int v = 0; v < result.mesh.V.rows(); ++v) {
        const int original = v < embedded ? v : opened.copyOf[v - embedded];
        result.place.push_back(parts.placeOf(original));
        result.sourceVertex.push_back(original < links.vertexCount() ? original : -1);
    }
    return result;
}

}  // namespace toile
