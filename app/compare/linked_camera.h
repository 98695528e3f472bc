// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QSizeF>

#include "app/render/camera_2d.h"

namespace toile {

/// One camera for several pictures of one size: what moves one moves all, and a millimetre has the
/// same size in each. Until it is moved by hand it shows the whole box.
class LinkedCamera : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// As seen in a picture of this size, logical pixels.
    Camera2D seenIn(const QSizeF& size) const;

    /// What there is to see on the sheet, mm.
    void setBox(const Eigen::AlignedBox2d& box);
    void setViewport(const QSizeF& size);
    void pan(const QPointF& delta);
    void zoomAt(const QPointF& at, double factor);
    /// Shows the whole box again, and from now on.
    void frameAll();

signals:
    void moved();

private:
    void follow();

    Camera2D camera_;
    Eigen::AlignedBox2d box_;
    bool followsAll_ = true;
};

}  // namespace toile
