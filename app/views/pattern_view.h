// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>

#include "app/render/camera.h"
#include "app/views/name_labels.h"
#include "app/views/old_outlines.h"
#include "app/views/piece_places.h"
#include "app/views/reference_gaps.h"
#include "app/views/scene_view.h"

namespace toile::app {

class RolledPiece;

/// The flat pieces at true proportions as they lie on the sheet, with rulers along two edges, grain
/// arrows and names: a drag that no tool takes moves the sheet, the wheel zooms to the cursor.
class PatternView : public SceneView {
    Q_OBJECT

public:
    PatternView(Document& document, ToolChoice& tools, QWidget* parent = nullptr);

    ViewKind kind() const override { return ViewKind::Pattern; }
    std::optional<SurfaceHit> hitAt(const QPointF& at) const override;
    bool answers() const override { return true; }
    std::optional<SeamHit> seamHitAt(const QPointF& at, double pixels,
                                     const SeamFilter& counts) const override;
    std::optional<QPointF> onScreen(int piece, int face,
                                    const Eigen::Vector3d& barycentric) const override;
    Eigen::Vector2d onSheet(const QPointF& at) const override;
    double pixelsPerMillimetre() const override { return camera_.pixelsPerMillimetre(); }

    const Camera2D& camera() const { return camera_; }
    /// Paints a piece that is walked along a seam; null: none.
    void setRolled(std::shared_ptr<const RolledPiece> rolled);
    const RolledPiece* rolled() const { return rolled_.get(); }
    /// Shows all of its way. Precondition: there is one.
    void frameRolled();
    /// The dashed places of pieces that are not flat, and what their buttons say.
    const PiecePlaces& piecePlaces() const { return others_; }
    void setHelp(std::map<int, QString> buttons);

signals:
    /// The button at the place of a piece that is not flat was pressed.
    void helpWanted(int piece);

protected:
    const LineRuns& lines() const override { return scene()->patternLines; }
    std::optional<QPointF> pointOnScreen(const LineVertex& vertex) const override;
    void setCameraViewport(double width, double height) override;
    void framePieces(const std::set<int>& pieces) override;
    bool frameLines(const SeamScene& seam) override;
    void frameSpot(const WorstSpot& spot, double radius) override;
    void drag(Drag kind, const QPointF& delta) override;
    void zoom(const QPointF& at, double factor) override;
    void paintScene(const RenderStyle& style, int width, int height, double ratio) override;
    std::optional<SpotPlace> placeNow(const WorstSpot& spot) const override;
    void paintText(QPainter& painter, const RenderStyle& style) override;
    bool clickOnOverlay(const QPointF& at) override;

private:
    void follow();
    /// Where a point of a flat piece is on the screen.
    QPointF placed(int piece, const Eigen::Vector2d& point) const;

    Camera2D camera_;
    PiecePlaces others_;
    OldOutlines old_;
    ReferenceGaps gaps_;
    KeptNames names_;
    std::shared_ptr<const RolledPiece> rolled_;
};

}  // namespace toile::app
