// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/cut_along.h"

#include <algorithm>
#include <set>

#include "core/cut/face_splitter.h"
#include "core/cut/open_cuts.h"

namespace toile {
namespace {

std::optional<Error> whyNotCuttable(const SurfaceLinks& links) {
    const EdgeTable& table = links.table();
    for (int e = 0; e < links.edgeCount(); ++e) {
        const int count = table.useStart[e + 1] - table.useStart[e];
        if (count > 2) {
            return Error{ErrorCode::NonManifoldEdge, "", ""};
        }
        if (count == 2 && links.twin(table.use[table.useStart[e]]) < 0) {
            return Error{ErrorCode::OpposedWinding, "", ""};
        }
    }
    return std::nullopt;
}

/// The path's vertices once it is part of the mesh.
Result<std::vector<int>> embed(const FaceParts& parts, FaceSplitter& splitter,
                               const PathPolyline& path, const Progress& progress) {
    const SurfaceLinks& links = parts.links();
    std::vector<int> vertices;
    int face = -1;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled, "", ""};
        }
        const SurfacePoint& point = path.points[i];
        const int vertex = splitter.insert(point);
        if (i == 0) {
            vertices.push_back(vertex);
            continue;
        }
        face = links.commonFace(path.points[i - 1], point, face);
        if (face < 0) {
            return cutError("", worded("points %1 and %2 of a path share no triangle",
                                       {figure(double(i)), figure(double(i + 1))}));
        }
        if (!splitter.connect(face, vertices.back(), vertex, vertices)) {
            return cutError("", worded("a path lost its way in a triangle"));
        }
        if (parts.isCrowded(face)) {
            return cutError("", worded("it crosses itself and the cuts before it so often that a "
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

}  // namespace

Result<CutResult> cutAlong(const MeshArrays& mesh, const std::vector<PathPolyline>& paths,
                           const CutOptions& options, const Progress& progress) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    const SurfaceLinks links(mesh, table);
    if (auto error = whyNotCuttable(links)) {
        return *error;
    }
    FaceParts parts(links);
    FaceSplitter splitter(parts, options.snap);
    std::vector<std::vector<int>> ways;
    std::vector<std::optional<Error>> errors;
    for (const PathPolyline& path : paths) {
        parts.mark();
        auto way = embed(parts, splitter, path, progress);
        if (!way && (!options.leavesOut || progress.isCancelled())) {
            return way.error();
        }
        if (!way) {
            parts.takeBack();
        }
        errors.push_back(way ? std::nullopt : std::optional(way.error()));
        ways.push_back(way ? std::move(*way) : std::vector<int>{});
    }
    parts.relax(edgesOf(parts, ways), progress);
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    CutResult result;
    const auto open = [&] {
        std::vector<std::vector<int>> refined;
        refined.reserve(ways.size());
        for (const auto& way : ways) {
            refined.push_back(parts.refined(way));
        }
        return openAlong(assemble(parts, result.sourceFace), refined);
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
