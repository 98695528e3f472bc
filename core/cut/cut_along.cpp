// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/cut_along.h"

#include <algorithm>
#include <optional>
#include <set>

#include "core/cut/face_parts.h"
#include "core/mesh/mesh_arrays.h"

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

/// The path's vertices once it is part of the mesh.
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
            return cutError({}, worded("a path lost its way in a triangle"));
        }
        if (parts.isCrowded(face)) {
            return cutError({}, worded("it crosses itself and the cuts before it so often that a "
                                       "triangle would fall into thousands of parts"));
        }
    }
    return vertices;
}

/// The edges of all paths, as they are now.
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

/// An edge that a path has cut although its two sides still have both ends in common: a vertex
/// between them is missing.
struct ShutEdge {
    int from, to;
    int face;  ///< the first of the two at it
};

/// A mesh parted along edges.
struct OpenedMesh {
    MeshArrays mesh;
    std::vector<int> copyOf;  ///< per vertex beyond those of the input: which one it copies
    std::vector<OpenedCut> cuts;
    std::vector<ShutEdge> stillShut;
};

/// A path's edge with the sides to its left and right.
struct Step {
    int left, right;  ///< uses
};

/// Parts a mesh along paths of vertices, neighbours joined by an edge. Every vertex is divided into
/// as many copies as the cuts divide the triangles around it into groups; the first keeps its
/// number. Rim edges and edges cut by an earlier path are left out. Cost: linear.
class Opener {
public:
    /// @param result  with the mesh
    Opener(OpenedMesh& result, const std::vector<std::vector<int>>& paths)
        : result_(result),
          source_(result.mesh),
          table_(buildEdgeTable(source_.F, static_cast<int>(source_.V.rows()))),
          links_(source_, table_),
          isCut_(table_.edges.rows(), 0),
          steps_(paths.size()) {
        for (std::size_t p = 0; p < paths.size(); ++p) {
            collect(paths[p], steps_[p]);
        }
    }

    void run() {
        partVertices();
        for (const auto& steps : steps_) {
            result_.cuts.push_back(follow(steps));
        }
    }

private:
    int newTail(int use) const { return tailOf(result_.mesh.F, use); }
    int newHead(int use) const { return headOf(result_.mesh.F, use); }

    /// The steps of a path; {-1, -1} where it runs along a rim or an earlier cut.
    void collect(const std::vector<int>& path, std::vector<Step>& steps) {
        for (std::size_t i = 1; i < path.size(); ++i) {
            const int e = findEdge(table_.edges, path[i - 1], path[i]);
            Step step{-1, -1};
            if (e >= 0 && isCut_[e] == 0 && links_.twin(table_.usesOf(e)[0]) >= 0) {
                isCut_[e] = 1;
                const int use = table_.usesOf(e)[0];
                const bool along = links_.tail(use) == path[i - 1];
                step = along ? Step{use, links_.twin(use)} : Step{links_.twin(use), use};
            }
            steps.push_back(step);
        }
    }

    void partVertices() {
        geometry::DisjointSets fans(static_cast<int>(source_.F.size()));
        std::vector<char> isTouched(source_.V.rows(), 0);
        for (int e = 0; e < table_.edges.rows(); ++e) {
            const std::span<const int> uses = table_.usesOf(e);
            if (isCut_[e] != 0) {
                isTouched[table_.edges(e, 0)] = 1;
                isTouched[table_.edges(e, 1)] = 1;
            } else if (uses.size() == 2) {
                joinCorners(source_.F, uses[0], uses[1], fans);
            }
        }
        const int sourceCount = static_cast<int>(source_.V.rows());
        result_.copyOf = divideVertices(result_.mesh.F, sourceCount, fans,
                                        [&](int v) { return isTouched[v] != 0; });
        const int added = static_cast<int>(result_.copyOf.size());
        result_.mesh.V.conservativeResize(sourceCount + added, 3);
        for (int k = 0; k < added; ++k) {
            result_.mesh.V.row(sourceCount + k) = source_.V.row(result_.copyOf[k]);
        }
    }

    OpenedCut follow(const std::vector<Step>& steps) {
        OpenedCut cut;
        bool isOpen = false;
        for (const Step& step : steps) {
            if (step.left < 0) {
                isOpen = false;
                continue;
            }
            const int leftFrom = newTail(step.left);
            const int leftTo = newHead(step.left);
            const int rightFrom = newHead(step.right);
            const int rightTo = newTail(step.right);
            if (!isOpen || cut.runs.back().left.back() != leftFrom ||
                cut.runs.back().right.back() != rightFrom) {
                cut.runs.push_back({{leftFrom}, {rightFrom}, 0});
                isOpen = true;
            }
            CutRun& run = cut.runs.back();
            const double length =
                (result_.mesh.V.row(leftTo) - result_.mesh.V.row(leftFrom)).norm();
            run.left.push_back(leftTo);
            run.right.push_back(rightTo);
            run.length += length;
            cut.length += length;
            if (leftFrom == rightFrom && leftTo == rightTo) {
                result_.stillShut.push_back({links_.tail(step.left), links_.head(step.left),
                                             std::min(step.left, step.right) / 3});
            }
        }
        return cut;
    }

    OpenedMesh& result_;
    const MeshArrays source_;
    const EdgeTable table_;
    const SurfaceLinks links_;
    std::vector<char> isCut_;
    std::vector<std::vector<Step>> steps_;
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
        std::optional<FaceParts> before;  // where the path may be taken back
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
        // A new vertex has the cut on both sides and nothing else, so that it parts: once is
        // enough.
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
