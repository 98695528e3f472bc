// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/scene_builder.h"

#include <algorithm>
#include <cmath>

#include "app/render/label_point.h"
#include "app/render/line_builder.h"
#include "app/render/vertex_values.h"

namespace toile {

namespace {

/// Finest ends of the colour bars: differences below these mean nothing to cloth.
constexpr double kFinestPercent = 0.1;
constexpr double kFinestDegrees = 0.1;

Eigen::AlignedBox3d boundsOf(const Points3& V) {
    Eigen::AlignedBox3d box;
    for (Eigen::Index i = 0; i < V.rows(); ++i) {
        const Eigen::Vector3d point = V.row(i).transpose();
        if (point.allFinite()) {
            box.extend(point);
        }
    }
    return box;
}

void put(float* out, const Eigen::Vector2d& v) {
    out[0] = static_cast<float>(v.x());
    out[1] = static_cast<float>(v.y());
}

void put(float* out, const Eigen::Vector3d& v) {
    for (int k = 0; k < 3; ++k) {
        out[k] = std::isfinite(v[k]) ? static_cast<float>(v[k]) : 0.0F;
    }
}

template <class Vertex>
void appendIndices(MeshBuffers<Vertex>& buffers, const Piece& piece, std::uint32_t base) {
    const auto append = [base](std::vector<std::uint32_t>& out, int index) {
        out.push_back(base + static_cast<std::uint32_t>(index));
    };
    for (Eigen::Index f = 0; f < piece.mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            append(buffers.triangles, piece.mesh.F(f, k));
        }
    }
    for (Eigen::Index e = 0; e < piece.table.edges.rows(); ++e) {
        for (int k = 0; k < 2; ++k) {
            append(buffers.edges, piece.table.edges(e, k));
        }
    }
    // Edges of one triangle only: of pieces that are no disks too, which have no boundary loop.
    for (Eigen::Index e = 0; e < piece.table.edges.rows(); ++e) {
        const auto at = static_cast<std::size_t>(e);
        if (piece.table.useStart[at + 1] - piece.table.useStart[at] == 1) {
            for (int k = 0; k < 2; ++k) {
                append(buffers.outline, piece.table.edges(e, k));
            }
        }
    }
}

TriangleRun runSince(std::size_t indicesBefore, std::size_t indicesNow) {
    return {static_cast<std::uint32_t>(indicesBefore / 3),
            static_cast<std::uint32_t>((indicesNow - indicesBefore) / 3)};
}

class Builder {
public:
    explicit Builder(Scene& scene) : scene_(scene) {}

    void addPiece(const Piece& piece, const FlatPiece* flat, const Eigen::Vector2d& offset) {
        index_ = static_cast<float>(scene_.pieces.size());
        PieceScene& entry = scene_.pieces.emplace_back();
        entry.flat = flat != nullptr;
        const VertexValues values = flat ? vertexValues(piece, flat->Q) : VertexValues{};
        addGarmentPart(piece, flat, values, entry);
        if (flat) {
            entry.offset = offset;
            addPatternPart(piece, *flat, values, entry);
        }
    }

private:
    void addGarmentPart(const Piece& piece, const FlatPiece* flat, const VertexValues& values,
                        PieceScene& entry) {
        auto& buffers = scene_.garment;
        const auto base = static_cast<std::uint32_t>(buffers.vertices.size());
        const std::size_t indicesBefore = buffers.triangles.size();
        const Points3 normals = vertexNormals(piece.mesh);
        for (Eigen::Index i = 0; i < piece.mesh.V.rows(); ++i) {
            GarmentVertex& vertex = buffers.vertices.emplace_back();
            const Eigen::Vector3d position = piece.mesh.V.row(i).transpose() - scene_.origin;
            put(vertex.position, position);
            put(vertex.normal, Eigen::Vector3d(normals.row(i).transpose()));
            put(vertex.flat, flat ? Eigen::Vector2d(flat->Q.row(i)) : Eigen::Vector2d::Zero());
            copyValues(values, i, vertex.values);
            vertex.piece = index_;
            if (position.allFinite()) {
                entry.box.extend(position);
            }
        }
        appendIndices(buffers, piece, base);
        entry.garmentRun = runSince(indicesBefore, buffers.triangles.size());
    }

    void addPatternPart(const Piece& piece, const FlatPiece& flat, const VertexValues& values,
                        PieceScene& entry) {
        auto& buffers = scene_.pattern;
        const auto base = static_cast<std::uint32_t>(buffers.vertices.size());
        const std::size_t indicesBefore = buffers.triangles.size();
        for (Eigen::Index i = 0; i < flat.Q.rows(); ++i) {
            PatternVertex& vertex = buffers.vertices.emplace_back();
            const Eigen::Vector2d point = flat.Q.row(i).transpose();
            put(vertex.flat, point);
            copyValues(values, i, vertex.values);
            vertex.piece = index_;
            entry.flatBox.extend(point);
        }
        appendIndices(buffers, piece, base);
        entry.patternRun = runSince(indicesBefore, buffers.triangles.size());
        entry.label = labelPoint(flat.Q, piece.mesh.F, piece.boundary);
        scene_.sheetBox.extend(entry.placedBox());
    }

    static void copyValues(const VertexValues& values, Eigen::Index vertex, float* out) {
        const bool known = values.area.size() > 0;
        out[0] = known ? values.area[vertex] : 0.0F;
        out[1] = known ? values.angle[vertex] : 0.0F;
        out[2] = known ? values.strain[vertex] : 0.0F;
    }

    Scene& scene_;
    float index_ = 0;
};

OverlayScale scaleOf(const Scene& scene, int value, bool signedValues, double finest) {
    std::vector<float> values;
    values.reserve(scene.pattern.vertices.size());
    for (const PatternVertex& vertex : scene.pattern.vertices) {
        values.push_back(vertex.values[value]);
    }
    return robustScale(std::move(values), signedValues, finest);
}

void reserve(const Garment& garment, Scene& scene) {
    std::size_t vertices = 0, faces = 0, edges = 0;
    for (const auto& piece : garment.pieces) {
        vertices += static_cast<std::size_t>(piece->mesh.V.rows());
        faces += static_cast<std::size_t>(piece->mesh.F.rows());
        edges += static_cast<std::size_t>(piece->table.edges.rows());
    }
    scene.pieces.reserve(garment.pieces.size());
    scene.garment.vertices.reserve(vertices);
    scene.garment.triangles.reserve(3 * faces);
    scene.garment.edges.reserve(2 * edges);
}

}  // namespace

std::shared_ptr<const Scene> buildScene(const Garment& garment, const PieceResults& results,
                                        const std::vector<Eigen::Vector2d>& offsets,
                                        Progress& progress) {
    auto scene = std::make_shared<Scene>();
    for (const auto& piece : garment.pieces) {
        scene->box.extend(boundsOf(piece->mesh.V));
    }
    if (!scene->box.isEmpty()) {
        scene->origin = scene->box.center();
        scene->box.translate(-scene->origin);
    }
    reserve(garment, *scene);

    progress.start(static_cast<double>(garment.pieces.size()));
    Builder builder(*scene);
    for (std::size_t i = 0; i < garment.pieces.size() && !progress.isCancelled(); ++i) {
        const PieceResult* result = i < results.size() ? results[i].get() : nullptr;
        const FlatPiece* flat = result && result->flat ? &*result->flat : nullptr;
        builder.addPiece(*garment.pieces[i], flat,
                         i < offsets.size() ? offsets[i] : Eigen::Vector2d::Zero());
        progress.advance(1);
    }
    if (progress.isCancelled()) {
        return scene;
    }
    addSeamLines(garment, results, *scene);
    addDesignerLines(garment, results, *scene);

    const auto at = [&scene](Overlay overlay) -> OverlayScale& {
        return scene->scales[static_cast<std::size_t>(overlay)];
    };
    at(Overlay::Area) = scaleOf(*scene, 0, true, kFinestPercent);
    at(Overlay::Angle) = scaleOf(*scene, 1, false, kFinestDegrees);
    at(Overlay::Strain) = scaleOf(*scene, 2, true, kFinestPercent);
    return scene;
}

}  // namespace toile
