// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/scene_builder.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "app/document/disposal.h"
#include "app/render/morph.h"
#include "app/render/overlay_values.h"
#include "app/render/piece_values.h"
#include "core/pattern/label.h"
#include "core/pattern/pattern.h"

namespace toile::app {

namespace {

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

void put(float* out, const Eigen::Vector3d& v) {
    for (int k = 0; k < 3; ++k) {
        out[k] = std::isfinite(v[k]) ? static_cast<float>(v[k]) : 0.0F;
    }
}

/// @return the range of the triangles
TriangleRun appendIndices(MeshIndices& mesh, const Piece& piece, std::uint32_t base) {
    const auto first = static_cast<std::uint32_t>(mesh.triangles.size() / 3);
    const auto append = [base](std::vector<std::uint32_t>& out, int index) {
        out.push_back(base + static_cast<std::uint32_t>(index));
    };
    for (Eigen::Index f = 0; f < piece.mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            append(mesh.triangles, piece.mesh.F(f, k));
        }
    }
    for (Eigen::Index e = 0; e < piece.table.edges.rows(); ++e) {
        for (int k = 0; k < 2; ++k) {
            append(mesh.edges, piece.table.edges(e, k));
        }
    }
    // Edges of one triangle only; works for pieces without a boundary loop, too.
    for (Eigen::Index e = 0; e < piece.table.edges.rows(); ++e) {
        const auto at = static_cast<std::size_t>(e);
        if (piece.table.useStart[at + 1] - piece.table.useStart[at] == 1) {
            for (int k = 0; k < 2; ++k) {
                append(mesh.outline, piece.table.edges(e, k));
            }
        }
    }
    return {first, static_cast<std::uint32_t>(piece.mesh.F.rows())};
}

class Builder {
public:
    explicit Builder(SceneCloth& scene) : scene_(scene) {}

    void addPiece(const Piece& piece, const FlatPiece* flat) {
        index_ = static_cast<float>(scene_.pieces.size());
        PieceScene& entry = scene_.pieces.emplace_back();
        entry.flat = flat != nullptr;
        const PieceValues values = flat ? pieceValues(piece, flat->Q) : PieceValues{};
        const auto base = static_cast<std::uint32_t>(scene_.vertices.size());
        addVertices(piece, flat, values.vertices, entry);
        entry.garmentRun = appendIndices(scene_.garment, piece, base);
        entry.garmentTree = treeOf<3>(&ClothVertex::position, scene_.garment, entry.garmentRun);
        if (flat) {
            entry.patternRun = appendIndices(scene_.pattern, piece, base);
            entry.patternTree = treeOf<2>(&ClothVertex::flat, scene_.pattern, entry.patternRun);
            entry.label = placeLabel(flatLoops(piece, *flat), {}).position;
            addFaces(values);
            entry.rest = bestRest(flat->Q, piece.mesh.V, scene_.origin);
        }
        entry.corners = outlineCorners(piece);
    }

private:
    void addVertices(const Piece& piece, const FlatPiece* flat, const OverlayFields& values,
                     PieceScene& entry) {
        const Points3 normals = vertexNormals(piece.mesh);
        for (Eigen::Index i = 0; i < piece.mesh.V.rows(); ++i) {
            ClothVertex& vertex = scene_.vertices.emplace_back();
            const Eigen::Vector3d position = piece.mesh.V.row(i).transpose() - scene_.origin;
            put(vertex.position, position);
            put(vertex.normal, Eigen::Vector3d(normals.row(i).transpose()));
            if (flat) {
                const Eigen::Vector2d point = flat->Q.row(i).transpose();
                Eigen::Map<Eigen::Vector2f>(vertex.flat) = point.cast<float>();
                entry.flatBox.extend(point);
            }
            copyValues(values, i, vertex.values, vertex.metric);
            vertex.piece = index_;
            if (position.allFinite()) {
                entry.box.extend(position);
            }
        }
    }

    template <int n>
    geometry::TriangleTree<n> treeOf(float (ClothVertex::*point)[n], const MeshIndices& mesh,
                                     const TriangleRun& run) const {
        return geometry::TriangleTree<n>(
            scene_.vertices.front().*point, sizeof(ClothVertex) / sizeof(float),
            std::span(mesh.triangles).subspan(3 * std::size_t{run.first}));
    }

    void addFaces(const PieceValues& values) {
        for (Eigen::Index f = 0; f < values.flatAreas.size(); ++f) {
            FaceValues& face = scene_.faces.emplace_back();
            copyValues(values.faces, f, face.values, face.metric);
            face.flatArea = values.flatAreas[f];
        }
    }

    static void copyValues(const OverlayFields& fields, Eigen::Index at, float* values,
                           float* metric) {
        if (fields.area.size() > 0) {
            values[0] = fields.area[at];
            values[1] = fields.angle[at];
            values[2] = fields.mostStrain[at];
            values[3] = fields.leastStrain[at];
        }
        const MetricTensor tensor =
            fields.area.size() > 0 ? fields.metric[static_cast<std::size_t>(at)] : MetricTensor{};
        metric[0] = static_cast<float>(tensor.E);
        metric[1] = static_cast<float>(tensor.F);
        metric[2] = static_cast<float>(tensor.G);
    }

    SceneCloth& scene_;
    float index_ = 0;
};

OverlayScale scaleOf(const Scene& scene, Overlay overlay) {
    const OverlayScale either{-1, 1};  // weighs both signs equally
    std::vector<float> values;
    values.reserve(scene.vertices.size());
    for (const ClothVertex& vertex : scene.vertices) {
        if (scene.pieces[static_cast<std::size_t>(vertex.piece)].flat) {
            values.push_back(static_cast<float>(
                overlayValue(overlay, sampleOf(vertex), Eigen::Vector2d::UnitY(), either)));
        }
    }
    return robustScale(std::move(values), traits(overlay).hasSign, traits(overlay).finest);
}

void reserve(const Garment& garment, SceneCloth& scene) {
    std::size_t vertices = 0, faces = 0, edges = 0;
    for (const auto& piece : garment.pieces) {
        vertices += static_cast<std::size_t>(piece->mesh.V.rows());
        faces += static_cast<std::size_t>(piece->mesh.F.rows());
        edges += static_cast<std::size_t>(piece->table.edges.rows());
    }
    scene.pieces.reserve(garment.pieces.size());
    scene.vertices.reserve(vertices);
    scene.garment.triangles.reserve(3 * faces);
    scene.garment.edges.reserve(2 * edges);
}

}  // namespace

const FlatPiece* flatPieceOf(const Garment& garment, const PieceResults& results, int piece) {
    const auto at = static_cast<std::size_t>(piece);
    const PieceResult* result = at < results.size() ? results[at].get() : nullptr;
    return result && result->piece == garment.pieces[at] && result->flat ? &*result->flat : nullptr;
}

namespace {

/// @return null if cancelled
std::shared_ptr<const SceneCloth> makeCloth(const Garment& garment, const PieceResults& results,
                                            Progress& progress) {
    auto cloth = sharedForDisposal(std::make_unique<SceneCloth>());
    cloth->madeOf.assign(garment.pieces.begin(), garment.pieces.end());
    cloth->results.assign(results.begin(), results.end());
    for (const auto& piece : garment.pieces) {
        cloth->box.extend(boundsOf(piece->mesh.V));
    }
    if (!cloth->box.isEmpty()) {
        cloth->origin = cloth->box.center();
        cloth->box.translate(-cloth->origin);
    }
    reserve(garment, *cloth);
    progress.start(static_cast<double>(garment.pieces.size()));
    Builder builder(*cloth);
    for (std::size_t i = 0; i < garment.pieces.size() && !progress.isCancelled(); ++i) {
        const FlatPiece* flat = flatPieceOf(garment, results, static_cast<int>(i));
        builder.addPiece(*garment.pieces[i], flat);
        progress.advance(1);
    }
    if (progress.isCancelled()) {
        return nullptr;
    }
    const Scene scene(cloth);
    cloth->glyphs = makeStrainGlyphs(scene);
    const OverlayScale strain = scaleOf(scene, Overlay::Principal);
    for (const OverlayTraits& known : kOverlays) {
        if (known.kind == OverlayKind::Flat) {
            cloth->scales[static_cast<std::size_t>(known.overlay)] =
                known.limit == LimitedBy::Nothing ? scaleOf(scene, known.overlay) : strain;
        }
    }
    return cloth;
}

/// Compares owners, so that an object that is gone differs from none.
template <class Value>
bool isMadeOf(const std::vector<std::weak_ptr<const Value>>& made,
              const std::vector<std::shared_ptr<const Value>>& now) {
    return std::ranges::equal(made, now, [](const auto& a, const auto& b) {
        return !a.owner_before(b) && !b.owner_before(a);
    });
}

}  // namespace

std::shared_ptr<const Scene> buildScene(const Garment& garment, const PieceResults& results,
                                        Progress& progress, const Pattern* pattern,
                                        const Scene* before) {
    const bool isSame = before && isMadeOf(before->cloth->madeOf, garment.pieces) &&
                        isMadeOf(before->cloth->results, results);
    const auto cloth = isSame ? before->cloth : makeCloth(garment, results, progress);
    if (!cloth) {
        return std::make_shared<const Scene>();
    }
    auto scene = sharedForDisposal(std::make_unique<Scene>(cloth));
    for (const PieceScene& piece : scene->pieces) {
        scene->edgeBoxes.push_back(piece.flatBox);
    }
    addSeamLines(garment, results, *scene);
    addOutlines(garment, results, *scene);
    addLeftOut(garment, *scene);
    addReferenceLines(garment, results, *scene);
    addExactOutlines(garment, results, *scene);
    if (pattern) {
        addCuttingLines(*pattern, *scene);
        addInternalLines(garment, results, *pattern, *scene);
    }
    return scene;
}

}  // namespace toile::app
