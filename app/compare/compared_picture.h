// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>

#include "app/compare/linked_camera.h"
#include "app/render/pattern_renderer.h"

namespace toile {

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
    explicit ComparedPicture(LinkedCamera& camera, QWidget* parent = nullptr);
    ~ComparedPicture() override;

    /// @param scene  of one piece; may be null
    void setPiece(std::shared_ptr<const Scene> scene, const SheetPlace& place);
    void setLook(const PictureLook& look);
    void setScaleBar(bool shown);
    /// Why nothing can be drawn; empty where all is well.
    const QString& problem() const { return problem_; }

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
    void changeEvent(QEvent* event) override;

private:
    void releaseGl();
    void paintWords();

    LinkedCamera& camera_;
    PatternRenderer renderer_;
    PictureLook look_;
    bool scaleBar_ = false;
    QString problem_;
    QPointF last_;
};

}  // namespace toile
