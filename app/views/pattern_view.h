// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/camera_2d.h"
#include "app/views/scene_view.h"

namespace toile {

/// The flat pieces at true proportions, the fabric's right side up: a drag moves the sheet, the
/// wheel zooms to the cursor.
class PatternView : public SceneView {
    Q_OBJECT

public:
    explicit PatternView(Document& document, QWidget* parent = nullptr);

    const Camera2D& camera() const { return camera_; }

protected:
    void setCameraViewport(double width, double height) override;
    void framePieces(const std::set<int>& pieces) override;
    bool frameLines(const SeamScene& seam) override;
    void drag(Drag kind, const QPointF& delta) override;
    void zoom(const QPointF& at, double factor) override;
    std::optional<int> pieceAt(const QPointF& at) const override;
    void paintScene(const RenderStyle& style, int width, int height, double ratio) override;
    void paintText(QPainter& painter, const RenderStyle& style) override;

private:
    void paintNames(QPainter& painter, const RenderStyle& style) const;
    QString emptyText() const;

    Camera2D camera_;
};

}  // namespace toile
