// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>

#include <Eigen/Geometry>

#include "app/render/camera_2d.h"
#include "app/views/tools/tool_view.h"

namespace toile {

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

}  // namespace toile
