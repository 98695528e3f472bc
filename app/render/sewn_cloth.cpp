// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/sewn_cloth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "core/cut/surface_point.h"
#include "core/prove/proof.h"

namespace toile::app {

namespace {

constexpr double kSewnPercent = 100;

/// The nearest triangle of a piece, as vertices of the scene, and barycentric weights.
LineAnchors::Anchor anchorOf(const Scene& scene, const PieceScene& piece,
                             const Eigen::Vector3d& point) {
    using Tree = geometry::TriangleTree<3>;
    LineAnchors::Anchor anchor;
    double nearest = Tree::kMissed;
    piece.garmentTree.search(
        [&](const Tree::Box& box) -> double {
            double square = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double at = point[static_cast<Eigen::Index>(k)];
                const double low = static_cast<double>(box.low[k]) - at,
                             high = at - static_cast<double>(box.high[k]);
                const double off = std::max({low, high, 0.0});
                square += off * off;
            }
            return square < nearest ? square : Tree::kMissed;
        },
        [&](std::uint32_t triangle) {
            const std::size_t first = 3 * (std::size_t{piece.garmentRun.first} + triangle);
            std::array<std::uint32_t, 3> corners{};
            Eigen::Matrix3d points;
            for (std::size_t k = 0; k < 3; ++k) {
                corners[k] = scene.garment.triangles[first + k];
                points.col(static_cast<Eigen::Index>(k)) = wornPoint(scene.vertices[corners[k]]);
            }
            const Eigen::Vector3d weights =
                nearestInTriangle(point, points.col(0), points.col(1), points.col(2));
            const double square = (points * weights - point).squaredNorm();
            if (square < nearest) {
                nearest = square;
                anchor.vertices = corners;
                for (std::size_t k = 0; k < 3; ++k) {
                    anchor.weights[k] = static_cast<float>(weights[static_cast<Eigen::Index>(k)]);
                }
            }
        });
    return anchor;
}

void addNormals(const Scene& scene, std::vector<SewnVertex>& vertices) {
    std::vector<Eigen::Vector3f> sums(vertices.size(), Eigen::Vector3f::Zero());
    const auto at = [&vertices](std::uint32_t v) -> Eigen::Vector3f {
        return Eigen::Map<const Eigen::Vector3f>(vertices[v].position);
    };
    const auto& triangles = scene.garment.triangles;
    for (std::size_t f = 0; f + 2 < triangles.size(); f += 3) {
        const Eigen::Vector3f a = at(triangles[f]);
        const Eigen::Vector3f normal = (at(triangles[f + 1]) - a).cross(at(triangles[f + 2]) - a);
        for (std::size_t k = 0; k < 3; ++k) {
            sums[triangles[f + k]] += normal;
        }
    }
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const float length = sums[v].norm();
        if (length > 0 && std::isfinite(length)) {
            Eigen::Map<Eigen::Vector3f>(vertices[v].normal) = sums[v] / length;
        }
    }
}

SewnVertex onCloth(const LineAnchors::Anchor& anchor, const std::vector<SewnVertex>& cloth) {
    SewnVertex vertex{};
    for (std::size_t k = 0; k < 3; ++k) {
        const SewnVertex& corner = cloth[anchor.vertices[k]];
        for (int i = 0; i < 3; ++i) {
            vertex.position[i] += anchor.weights[k] * corner.position[i];
        }
        vertex.isSewn = std::max(vertex.isSewn, anchor.weights[k] > 0 ? corner.isSewn : 0.0F);
    }
    return vertex;
}

OverlayScale spanOf(const std::vector<SewnVertex>& vertices, float SewnVertex::*value,
                    double finest) {
    std::vector<float> values;
    values.reserve(vertices.size());
    for (const SewnVertex& vertex : vertices) {
        if (vertex.isSewn > 0) {
            values.push_back(vertex.*value);
        }
    }
    return robustScale(std::move(values), true, finest);
}

float finite(double value) {
    return std::isfinite(value) ? static_cast<float>(value) : 0.0F;
}

}  // namespace

std::shared_ptr<const LineAnchors> lineAnchors(const Scene& scene) {
    auto anchors = std::make_shared<LineAnchors>();
    anchors->lines.resize(scene.lineVertices.size());
    const auto add = [&](const VertexRun& run) {
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i) {
            const auto piece = static_cast<std::size_t>(scene.lineVertices[i].piece);
            if (piece < scene.pieces.size()) {
                anchors->lines[i] =
                    anchorOf(scene, scene.pieces[piece], wornPoint(scene.lineVertices[i]));
            }
        }
    };
    const LineRuns& runs = scene.garmentLines;
    for (const auto& sides : runs.seams) {
        std::ranges::for_each(sides, add);
    }
    std::ranges::for_each(runs.internal, add);
    std::ranges::for_each(runs.outlines, add);
    return anchors;
}

std::shared_ptr<const SewnCloth> sewnCloth(std::shared_ptr<const Scene> scene,
                                           std::shared_ptr<const LineAnchors> anchors,
                                           const std::vector<Points3>& sewn, const Proof* proof,
                                           SewnPattern of) {
    auto cloth = std::make_shared<SewnCloth>();
    cloth->vertices.resize(scene->vertices.size());
    cloth->isMeasured = proof != nullptr;
    cloth->of = of;
    for (std::size_t v = 0, first = 0; v < scene->vertices.size(); ++v) {
        const ClothVertex& worn = scene->vertices[v];
        first = v > 0 && worn.piece != scene->vertices[v - 1].piece ? v : first;
        SewnVertex& vertex = cloth->vertices[v];
        std::copy_n(worn.position, 3, vertex.position);
        std::copy_n(worn.normal, 3, vertex.normal);
        const auto piece = static_cast<std::size_t>(worn.piece);
        const auto at = static_cast<Eigen::Index>(v - first);
        if (piece >= sewn.size() || at >= sewn[piece].rows() || !sewn[piece].row(at).allFinite()) {
            continue;
        }
        const Eigen::Vector3d point = sewn[piece].row(at).transpose() - scene->origin;
        Eigen::Map<Eigen::Vector3f>(vertex.position) = point.cast<float>();
        vertex.isSewn = 1;
        cloth->box.extend(point);
        if (proof) {
            vertex.gap = finite(proof->pieces[piece].gap[at]);
            vertex.strain = finite(kSewnPercent * proof->pieces[piece].strain[at]);
        }
    }
    addNormals(*scene, cloth->vertices);
    cloth->lineVertices.reserve(anchors->lines.size());
    for (const LineAnchors::Anchor& anchor : anchors->lines) {
        cloth->lineVertices.push_back(cloth->vertices.empty() ? SewnVertex{}
                                                              : onCloth(anchor, cloth->vertices));
    }
    if (proof) {
        cloth->gap = spanOf(cloth->vertices, &SewnVertex::gap, traits(Overlay::Gap).finest);
        cloth->strain =
            spanOf(cloth->vertices, &SewnVertex::strain, traits(Overlay::WornStrain).finest);
    }
    cloth->scene = std::move(scene);
    cloth->anchors = std::move(anchors);
    return cloth;
}

std::shared_ptr<const SewnCloth> sewnCloth(std::shared_ptr<const Scene> scene, const Proof& proof,
                                           SewnPattern of,
                                           std::shared_ptr<const LineAnchors> anchors) {
    std::vector<Points3> sewn;
    sewn.reserve(proof.pieces.size());
    for (const ProvenPiece& piece : proof.pieces) {
        sewn.push_back(piece.sewn);
    }
    if (!anchors) {
        anchors = lineAnchors(*scene);
    }
    return sewnCloth(std::move(scene), std::move(anchors), sewn, &proof, of);
}

std::optional<double> sewnValue(const SewnCloth& cloth, Overlay overlay, std::size_t face,
                                const Eigen::Vector3d& barycentric) {
    double value = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const SewnVertex& corner = cloth.vertices[cloth.scene->pattern.triangles[3 * face + k]];
        if (!(corner.isSewn > 0) || !cloth.isMeasured) {
            return std::nullopt;
        }
        value += barycentric[static_cast<Eigen::Index>(k)] *
                 static_cast<double>(overlay == Overlay::Gap ? corner.gap : corner.strain);
    }
    return value;
}

}  // namespace toile::app
