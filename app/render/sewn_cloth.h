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

/// Of a vertex of cloth or of a line on it, where the pattern is sewn back together. Millimetres;
/// positions are relative to Scene::origin.
struct SewnVertex {
    float position[3];
    float normal[3];  ///< unit, towards the fabric's right side
    float gap;        ///< mm, outside of the design above 0
    float strain;     ///< percent
    float isSewn;     ///< 1, or 0 of what stays where the garment has it
};

/// Where the lines that a scene draws over the garment lie on its cloth: for each vertex of them
/// three of the cloth and their weights. Depends on the scene alone.
struct LineAnchors {
    struct Anchor {
        std::array<std::uint32_t, 3> vertices{};
        std::array<float, 3> weights{};  ///< all 0: it lies on none
    };
    std::vector<Anchor> lines;  ///< one per Scene::lineVertices
};

/// Pure, thread-safe. Cost: a search in the piece's tree for each vertex of the lines.
std::shared_ptr<const LineAnchors> lineAnchors(const Scene& scene);

/// A garment's pattern sewn back together, ready for upload beside the scene, which stays as it is.
/// Immutable.
struct SewnCloth {
    std::shared_ptr<const Scene> scene{};  ///< not null
    std::shared_ptr<const LineAnchors> anchors{};
    std::vector<SewnVertex> vertices{}, lineVertices{};  ///< one per vertex of the scene's
    Eigen::AlignedBox3d box{};                           ///< relative to Scene::origin
    OverlayScale gap{-1, 1}, strain{-1, 1};              ///< ends of the colours, mm and percent
    bool isMeasured = false;  ///< there are gap and strain, and not the way there alone
    SewnPattern of = SewnPattern::Own;

    const OverlayScale& scale(Overlay overlay) const {
        return overlay == Overlay::Gap ? gap : strain;
    }
};

/// @param scene    not null
/// @param anchors  its own, not null
/// @param sewn     per piece where its vertices lie, mm; pieces without cloth have no rows
/// @param proof    of the same, for gap and strain; null: there is none yet
/// Pure, thread-safe. Cost: linear.
std::shared_ptr<const SewnCloth> sewnCloth(std::shared_ptr<const Scene> scene,
                                           std::shared_ptr<const LineAnchors> anchors,
                                           const std::vector<Points3>& sewn, const Proof* proof,
                                           SewnPattern of = SewnPattern::Own);
/// The same of a whole proof. @param anchors  null: they are found
std::shared_ptr<const SewnCloth> sewnCloth(std::shared_ptr<const Scene> scene, const Proof& proof,
                                           SewnPattern of = SewnPattern::Own,
                                           std::shared_ptr<const LineAnchors> anchors = nullptr);

/// What `Overlay::Gap` or `Overlay::WornStrain` shows within a triangle; none where it is not sewn.
/// @param face  counted in Scene::pattern
std::optional<double> sewnValue(const SewnCloth& cloth, Overlay overlay, std::size_t face,
                                const Eigen::Vector3d& barycentric);

}  // namespace toile::app
