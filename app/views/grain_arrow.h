// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QPointF>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

class QPainter;

namespace toile::app {

class Document;
class SheetMap;
class ToolView;
struct RenderStyle;

/// The grain arrow of a flat piece on the sheet, mm.
struct GrainArrow {
    Eigen::Vector2d middle;
    Eigen::Vector2d direction;  ///< unit vector, along the warp
    double length = 0;

    Eigen::Vector2d end(double share) const { return middle + share * length * direction; }
};

/// Uses the grain line of files (`MarkPlaces`). If that is too short to see, the arrow goes to the
/// roomiest place on the cloth. Its length can be grabbed even on a narrow piece. Nullopt if the
/// piece is not flat.
/// @param pixelsPerMillimetre  of the target screen
std::optional<GrainArrow> grainArrow(const Document& document, int piece,
                                     double pixelsPerMillimetre);

/// Paints one arrow on the screen, for tools.
void paintArrow(QPainter& painter, const RenderStyle& style, const QPointF& tail,
                const QPointF& tip, bool marked, bool stated);

/// An arrow on the screen, logical pixels.
struct DrawnArrow {
    int piece;
    QLineF line;
};

/// Paints the arrows of all flat pieces, dashed where the grain is unset.
/// @param strong  emphasise arrows and show them on small pieces too, while grain is being edited
/// @return their positions
std::vector<DrawnArrow> paintGrainArrows(QPainter& painter, const RenderStyle& style,
                                         const SheetMap& onScreen, const Document& document,
                                         bool strong);
/// Paints one arrow as grabbed or hovered.
void paintMarkedArrow(QPainter& painter, const RenderStyle& style, const ToolView& view,
                      const GrainArrow& arrow);

class Document;
class ToolView;
struct RenderStyle;
struct Scene;

/// The grain arrows on the worn cloth, at the places of the pieces' names. Finds those places once
/// per scene, at a cost linear in the triangles. Testing occlusion costs one `hitAt` per piece.
class GarmentArrows {
public:
    /// Paints only arrows whose middle is not hidden by another piece.
    /// @param marked  piece whose arrow is emphasised; -1: none
    void paint(QPainter& painter, const RenderStyle& style, const ToolView& view,
               const Document& document, int marked);

private:
    /// Position of a piece's name on its mesh.
    struct NamePlace {
        int face = -1;
        Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< the face's first corner, flat
        /// Weights of the second and third corner per mm of flat coordinates.
        Eigen::Matrix2d weights = Eigen::Matrix2d::Zero();
        Eigen::Vector2d label = Eigen::Vector2d::Zero();
    };

    static std::optional<NamePlace> namePlaceOf(const Scene& scene, int piece);
    void find(const std::shared_ptr<const Scene>& scene);

    std::weak_ptr<const Scene> scene_;  ///< scene of the places; weak so as not to keep it alive
    std::vector<std::optional<NamePlace>> namePlaces_;
};

}  // namespace toile::app
