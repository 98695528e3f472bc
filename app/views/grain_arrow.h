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

/// Where a flat piece's grain arrow is on the sheet, mm.
struct GrainArrow {
    Eigen::Vector2d middle;
    Eigen::Vector2d direction;  ///< unit vector, along the warp
    double length = 0;

    Eigen::Vector2d end(double share) const { return middle + share * length * direction; }
};

/// Where files have the piece's grain line (`MarkPlaces`); where that is too short to be seen,
/// where there is most room on the cloth, and long enough to be grabbed however narrow that is.
/// Nothing where the piece is not flat.
/// @param pixelsPerMillimetre  of the screen that it is for
std::optional<GrainArrow> grainArrow(const Document& document, int piece,
                                     double pixelsPerMillimetre);

/// Paints one arrow on the screen, as tools show it.
void paintArrow(QPainter& painter, const RenderStyle& style, const QPointF& tail,
                const QPointF& tip, bool marked, bool stated);

/// An arrow on the screen, logical pixels.
struct DrawnArrow {
    int piece;
    QLineF line;
};

/// Paints the arrows of all flat pieces, dashed where the grain is unset.
/// @param strong  while the grain is what is being worked on: also of pieces too small to be worth
/// it
/// @return where they lie
std::vector<DrawnArrow> paintGrainArrows(QPainter& painter, const RenderStyle& style,
                                         const SheetMap& onScreen, const Document& document,
                                         bool strong);
/// Paints one arrow as held or pointed at.
void paintMarkedArrow(QPainter& painter, const RenderStyle& style, const ToolView& view,
                      const GrainArrow& arrow);

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
