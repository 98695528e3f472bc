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

/// The garment in 3D. A drag turns it, Shift+drag moves it, the wheel zooms to the cursor, and the
/// number pad selects the standard views. `setMorph` shows it between garment and pattern. Its
/// cloth can be picked only at either end of the morph.
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
    /// Performs the action of a number pad key.
    void look(ViewKey key);
    /// Morph between the garment (0) and the flat pattern (1).
    double morph() const { return morph_; }
    void setMorph(double way);
    /// Position between the design (0) and the pattern sewn back together (1). It is 0 if nothing
    /// is sewn, or during the morph to the pattern. While sewing is running, the cloth is shown as
    /// far as it has come.
    double sewnWay() const;
    /// Does not affect picking, which still uses the designed cloth.
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
    /// Positions of the pieces during the morph, cached while nothing moves.
    struct Motions {
        std::shared_ptr<const Scene> scene;
        SheetPlaces places;
        Morph morph;
        std::vector<SpaceMotion> ofPieces;
    };

    Morph morphState() const;
    const Motions& motions() const;
    /// A point of a piece as drawn, interpolated during the morph. Calls `flat` only then.
    template <class Flat>
    Eigen::Vector3d asDrawn(int piece, const Eigen::Vector3d& worn, const Flat& flat) const;
    std::optional<QPointF> projected(const Eigen::Vector3d& point) const;
    /// The point of the sheet under a pixel, for a sheet that faces the eye upright.
    Eigen::Vector2d onStandingSheet(const QPointF& at) const;
    void setDirection(const ViewDirection& direction);
    /// Whether the right side of the cloth faces the eye there.
    bool isFacing(const WorstSpot& spot) const;
    /// Whether other cloth is in front of it.
    bool isHidden(const WorstSpot& spot) const;

    double morph_ = 0, sewnWay_ = 0;
    Camera3D camera_;
    mutable std::optional<Motions> motions_;
};

}  // namespace toile::app
