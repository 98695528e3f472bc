// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>
#include <memory>

#include "app/render/camera.h"
#include "app/render/pattern_renderer.h"

namespace toile::app {

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

/// How all pictures of a comparison are painted.
struct PictureLook {
    ViewState view{};
    Fabric fabric = fabricPresets().front();
    OverlayScale scale{};
};

/// One flat piece at the scale of the pictures beside it. A drag with any button moves all of them,
/// the wheel or + and - zoom, a double click or F shows the whole piece again.
class ComparedPicture : public QOpenGLWidget {
    Q_OBJECT

public:
    ComparedPicture(LinkedCamera& camera, bool hasScaleBar, QWidget* parent = nullptr);
    ~ComparedPicture() override;

    /// @param scene  of one piece; may be null
    void setPiece(std::shared_ptr<const Scene> scene, const SheetPlace& place,
                  const PictureLook& look);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void releaseGl();
    void paintWords();

    LinkedCamera& camera_;
    PatternRenderer renderer_;
    ViewState view_{};
    bool hasScaleBar_;
    QString problem_;  ///< why nothing can be drawn; empty where all is well
    QPointF last_;
};

}  // namespace toile::app
