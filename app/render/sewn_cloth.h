// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/render/scene.h"
#include "core/mesh/mesh_arrays.h"
#include "core/prove/proof_settings.h"

namespace toile {
struct Proof;
}  // namespace toile

namespace toile::app {

/// A vertex of cloth, or of a line on it, in the pattern sewn back together. Millimetres; positions
/// are relative to Scene::origin.
struct SewnVertex {
    float position[3];
    float normal[3];  ///< unit, towards the fabric's right side
    float gap;        ///< mm, positive outside the design
    float strain;     ///< percent
    float isSewn;     ///< 1; or 0 if the vertex stays as in the garment
};

/// Positions of the scene's lines on the cloth: for each line vertex, three cloth vertices and
/// their weights. Depends on the scene only.
struct LineAnchors {
    struct Anchor {
        std::array<std::uint32_t, 3> vertices{};
        std::array<float, 3> weights{};  ///< all 0: not on the cloth
    };
    std::vector<Anchor> lines;  ///< one per Scene::lineVertices
};

/// Pure, thread-safe. Cost: a tree search for each line vertex.
std::shared_ptr<const LineAnchors> lineAnchors(const Scene& scene);

/// A garment's pattern sewn back together, uploaded in addition to the unchanged scene. Immutable.
struct SewnCloth {
    std::shared_ptr<const Scene> scene{};  ///< not null
    std::shared_ptr<const LineAnchors> anchors{};
    std::vector<SewnVertex> vertices{}, lineVertices{};  ///< one per scene vertex and line vertex
    Eigen::AlignedBox3d box{};                           ///< relative to Scene::origin
    OverlayScale gap{-1, 1}, strain{-1, 1};              ///< colour scales, mm and percent
    bool isMeasured = false;  ///< gap and strain are known; false while sewing is in progress
    SewnPattern of = SewnPattern::Own;

    const OverlayScale& scale(Overlay overlay) const {
        return overlay == Overlay::Gap ? gap : strain;
    }
};

/// @param scene    not null
/// @param anchors  anchors of that scene, not null
/// @param sewn     vertex positions per piece, mm; pieces without cloth have no rows
/// @param proof    the matching proof with gap and strain; null if not available yet
/// Pure, thread-safe. Cost: linear.
std::shared_ptr<const SewnCloth> sewnCloth(std::shared_ptr<const Scene> scene,
                                           std::shared_ptr<const LineAnchors> anchors,
                                           const std::vector<Points3>& sewn, const Proof* proof,
                                           SewnPattern of = SewnPattern::Own);
/// The same from a complete proof. @param anchors  null: computed here
std::shared_ptr<const SewnCloth> sewnCloth(std::shared_ptr<const Scene> scene, const Proof& proof,
                                           SewnPattern of = SewnPattern::Own,
                                           std::shared_ptr<const LineAnchors> anchors = nullptr);

/// The value of `Overlay::Gap` or `Overlay::WornStrain` in a triangle; nullopt if it is not sewn.
/// @param face  index in Scene::pattern
std::optional<double> sewnValue(const SewnCloth& cloth, Overlay overlay, std::size_t face,
                                const Eigen::Vector3d& barycentric);

}  // namespace toile::app
