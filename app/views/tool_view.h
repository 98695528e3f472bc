// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "app/render/camera.h"
#include "app/render/picking.h"
#include "app/render/render_style.h"

namespace toile::app {

/// A place on the screen to reckon with.
inline Eigen::Vector2d pixels(const QPointF& at) {
    return {at.x(), at.y()};
}

enum class ViewKind { Garment, Pattern };

/// What a tool may ask of the view that it works in. Screen places are logical pixels from the
/// view's upper left corner.
class ToolView {
public:
    virtual ~ToolView() = default;

    virtual ViewKind kind() const = 0;
    /// Whether the cloth answers the pointer: not while it is on its way to the pattern.
    virtual bool answers() const = 0;
    /// The cloth under a pixel.
    virtual std::optional<SurfaceHit> hitAt(const QPointF& at) const = 0;
    /// The seam line, or free edge, nearest to a pixel, of those within so many pixels that are
    /// seen and count.
    virtual std::optional<SeamHit> seamHitAt(const QPointF& at, double pixels,
                                             const SeamFilter& counts) const = 0;
    /// Where a place on a piece is on the screen; nothing where it is not drawn: behind the eye, or
    /// of a piece that is not flat.
    virtual std::optional<QPointF> onScreen(int piece, int face,
                                            const Eigen::Vector3d& barycentric) const = 0;
    /// Both sides of a seam of the scene, as far as they are drawn.
    virtual std::vector<QPolygonF> seamOnScreen(int seam) const = 0;
    /// The point of the sheet under a pixel, mm. In the pattern view only.
    virtual Eigen::Vector2d onSheet(const QPointF& at) const = 0;
    /// Of the sheet; in the garment view at the depth of its middle.
    virtual double pixelsPerMillimetre() const = 0;
    /// Shows the selected pieces; where there are none the selected seam, else everything.
    virtual void frameSelection() = 0;
    /// Everything of the garment.
    virtual void frameAll() = 0;
    /// Paints again soon.
    virtual void repaintSoon() = 0;
};

/// From the sheet to the screen, in the pattern view; the way back is ToolView::onSheet.
class SheetMap {
public:
    explicit SheetMap(const ToolView& view)
        : corner_(view.onSheet({0, 0})), scale_(view.pixelsPerMillimetre()) {}
    explicit SheetMap(const Camera2D& camera)
        : corner_(camera.toWorld(0, 0)), scale_(camera.pixelsPerMillimetre()) {}

    double pixelsPerMillimetre() const { return scale_; }

    QPointF operator()(const Eigen::Vector2d& point) const {
        return {(point.x() - corner_.x()) * scale_, (corner_.y() - point.y()) * scale_};
    }

    QRectF operator()(const Eigen::AlignedBox2d& box) const {
        return QRectF((*this)(box.min()), (*this)(box.max())).normalized();
    }

private:
    Eigen::Vector2d corner_;  ///< upper left
    double scale_;
};

}  // namespace toile::app
