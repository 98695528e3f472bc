// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

class QPainter;

namespace toile::app {

class Document;
class ToolView;
struct RenderStyle;
struct Scene;

/// The grain arrows on the worn cloth, at the places of the pieces' names. Finds those places once
/// per scene, which costs the triangles; what other pieces hide costs a look (`hitAt`) per piece.
class GarmentArrows {
public:
    /// Only arrows whose middle no other piece hides.
    /// @param marked  a piece whose arrow is to stand out; -1: none
    void paint(QPainter& painter, const RenderStyle& style, const ToolView& view,
               const Document& document, int marked);

private:
    /// Where a piece's name is on its mesh.
    struct NamePlace {
        int face = -1;
        Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< the face's first corner, flat
        /// Weights of the second and third corner per mm of flat coordinates.
        Eigen::Matrix2d weights = Eigen::Matrix2d::Zero();
        Eigen::Vector2d label = Eigen::Vector2d::Zero();
    };

    static std::optional<NamePlace> namePlaceOf(const Scene& scene, int piece);
    void find(const std::shared_ptr<const Scene>& scene);

    std::weak_ptr<const Scene> scene_;  ///< of the places; no reason to keep it
    std::vector<std::optional<NamePlace>> namePlaces_;
};

}  // namespace toile::app
