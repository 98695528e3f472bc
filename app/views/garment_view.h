// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/document/view_state.h"
#include "app/render/camera.h"
#include "app/render/morph.h"
#include "app/views/navigation.h"
#include "app/views/scene_view.h"

namespace toile::app {

/// The garment in 3D: a drag turns it, with Shift moves it, the wheel zooms to the cursor, the keys
/// of the number pad turn it to its sides. On its way to the pattern (`setMorph`) it is shown as
/// flat as it is then; its cloth answers the pointer where it is all garment or all pattern.
class GarmentView : public SceneView {
    Q_OBJECT

public:
    GarmentView(Document& document, ToolChoice& tools, QWidget* parent = nullptr);

    ViewKind kind() const override { return ViewKind::Garment; }
    std::optional<SurfaceHit> hitAt(const QPointF& at) const override;
    bool answers() const override { return morph_ == 0 || morph_ == 1; }
    std::optional<SeamHit> seamHitAt(const QPointF& at, double pixels,
                                     const SeamFilter& counts) const override;
    std::optional<QPointF> onScreen(int piece, int face,
                                    const Eigen::Vector3d& barycentric) const override;
    std::optional<WornPlace> wornPlace(const Eigen::Vector3d& point) const override;
    Eigen::Vector2d onSheet(const QPointF& at) const override;
    double pixelsPerMillimetre() const override { return camera_.pixelsPerMillimetre(); }

    const Camera3D& camera() const { return camera_; }
    /// What a key of the number pad does.
    void look(ViewKey key);
    /// How far the garment is shown on its way to the pattern: 0 garment, 1 flat.
    double morph() const { return morph_; }
    void setMorph(double way);
    /// How far it is shown on its way from the design to the pattern sewn back together, 0 to 1;
    /// 0 where nothing is sewn, or on the way to the pattern. While it is being sewn it is shown as
    /// far as that is.
    double sewnWay() const;
    /// The pointer still means the cloth as the design has it.
    void setSewnWay(double way);

signals:
    void orthographicChanged(bool on);

protected:
    const LineRuns& lines() const override { return scene()->garmentLines; }
    std::optional<QPointF> pointOnScreen(const LineVertex& vertex) const override;
    void setCameraViewport(double width, double height) override;
    void framePieces(const std::set<int>& pieces) override;
    bool frameLines(const SeamScene& seam) override;
    void frameSpot(const WorstSpot& spot, double radius) override;
    void turnCamera(const QPointF& delta) override;
    void panCamera(const QPointF& delta) override;
    void zoomCamera(const QPointF& at, double factor) override;
    void paintScene(const RenderStyle& style, int width, int height, double ratio) override;
    std::optional<SpotPlace> placeNow(const WorstSpot& spot) const override;
    void paintText(QPainter& painter, const RenderStyle& style) override;
    bool clickOnOverlay(const QPointF& at) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// Where the pieces are on the way, worked out once for as long as nothing moves.
    struct Motions {
        std::shared_ptr<const Scene> scene;
        SheetPlaces places;
        Morph morph;
        std::vector<SpaceMotion> ofPieces;
    };

    Morph morphState() const;
    const Motions& motions() const;
    /// A point of a piece as it is drawn: on its way where the garment is. `flat` is asked for only
    /// there.
    template <class Flat>
    Eigen::Vector3d asDrawn(int piece, const Eigen::Vector3d& worn, const Flat& flat) const;
    std::optional<QPointF> projected(const Eigen::Vector3d& point) const;
    /// The point of the sheet under a pixel, where the sheet stands before the eye.
    Eigen::Vector2d onStandingSheet(const QPointF& at) const;
    void setDirection(const ViewDirection& direction);
    /// Whether the right side of the cloth is towards the eye there.
    bool isFacing(const WorstSpot& spot) const;
    /// Whether other cloth lies before it.
    bool isHidden(const WorstSpot& spot) const;

    double morph_ = 0, sewnWay_ = 0;
    Camera3D camera_;
    mutable std::optional<Motions> motions_;
};

}  // namespace toile::app
