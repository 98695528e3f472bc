// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <set>

#include "app/render/render_style.h"
#include "app/render/scene.h"
#include "app/views/callouts.h"
#include "app/views/canvas.h"
#include "app/views/hover_tracker.h"
#include "app/views/tool.h"

class QPainter;

namespace toile::app {

class Document;
class DocumentChange;
class ToolChoice;

/// A place on a seam; `along` as in a SeamHit, on the left side.
struct SeamDot {
    int seam = -1;
    double along = 0;
};

/// A view of the document's scene. Sends pointer events to the chosen tool, and those that no tool
/// takes to the canvas. Derived views move their camera and paint. Stores a camera, but no garment
/// data.
class SceneView : public RenderedWidget, public ToolView, private CanvasCamera {
    Q_OBJECT

public:
    std::vector<QPolygonF> seamOnScreen(int seam) const override;
    std::optional<QPointF> onSeam(int seam, int side, double along) const override;
    void frameSelection() override;
    /// Frames both sides of the selected seam; does nothing without one.
    void frameSeam();
    void frameAll() override;
    /// Frames a spot closely, ringed until the selection or the pieces change.
    void showSpot(const WorstSpot& spot);
    /// The ringed spot, if any.
    const std::optional<WorstSpot>& shownSpot() const { return shown_; }
    void repaintSoon() override { update(); }
    /// True once the current scene is on the screen; used before taking screenshots.
    bool isUpToDate() const;
    /// Sets the spots to mark, as far as they are visible.
    void setWorstSpots(FlaggedSpots spots);
    const FlaggedSpots& spots() const { return spots_; }
    /// The marked spot nearest to `at` within this distance.
    std::optional<WorstSpot> markedSpotAt(const QPointF& at, double pixels) const;
    /// Marks a place on a seam.
    void setSeamDot(std::optional<SeamDot> dot);

signals:
    /// Asks for a context menu: the right button was clicked without a drag (`pointed`), or a key
    /// asks for the selection's menu.
    void menuWanted(const QPointF& at, bool pointed);
    /// The pointer has entered the view.
    void entered();
    /// The hit on the cloth under the pointer; nullopt off the cloth or after leaving.
    void pointed(const std::optional<toile::app::SurfaceHit>& hit);

protected:
    SceneView(Document& document, ToolChoice& tools, std::unique_ptr<SceneRenderer> painter,
              QWidget* parent);

    /// The scene's lines as drawn in this view.
    virtual const LineRuns& lines() const = 0;
    /// Where a point of a line is drawn; nullopt if it is not visible.
    virtual std::optional<QPointF> pointOnScreen(const LineVertex& vertex) const = 0;
    virtual void setCameraViewport(double width, double height) = 0;
    /// @param pieces never empty
    virtual void framePieces(const std::set<int>& pieces) = 0;
    /// @return false if no part of the seam is drawn
    virtual bool frameLines(const SeamScene& seam) = 0;
    /// @param radius mm around the spot to show
    virtual void frameSpot(const WorstSpot& spot, double radius) = 0;
    /// Current position of a spot in the view; nullopt if it is not visible.
    virtual std::optional<SpotPlace> placeNow(const WorstSpot& spot) const = 0;
    virtual void turnCamera(const QPointF& delta) { panCamera(delta); }
    virtual void panCamera(const QPointF& delta) = 0;
    virtual void zoomCamera(const QPointF& at, double factor) = 0;
    virtual void paintScene(const RenderStyle& style, int width, int height, double ratio) = 0;
    virtual void paintText(QPainter& painter, const RenderStyle& style) = 0;
    /// Areas covered by other widgets over the view, logical pixels.
    std::vector<QRectF> covered() const;
    /// Handles a click on something painted by `paintText`. @return whether it had an effect
    virtual bool clickOnOverlay(const QPointF&) { return false; }

    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

    const Scene* scene() const;
    /// Call when the camera has moved without the pointer, because the hovered feature is stale.
    void cameraMoved();
    /// True until the user moves the camera.
    bool followsAll() const { return followsAll_; }
    /// Call when the camera was set to show something specific.
    void stopFollowing();
    /// Placement of the scene's pieces on the sheet.
    const SheetPlaces& places() const;
    const ToolChoice& tools() const { return tools_; }
    Document& document_;

private:
    /// Owner of the current mouse press.
    enum class Press { None, Tool, Camera, Overlay };

    void onChanged(const DocumentChange& what);
    void turn(const QPointF& delta) override;
    void pan(const QPointF& delta) override;
    void zoom(const QPointF& at, double factor) override;
    /// The user moves the camera, so stop framing everything. Ignored while nothing is visible yet.
    void takeByHand();
    /// Ends a press whose release was lost, cancelling what it began.
    void endPress();
    void updateCursor();
    void setSpace(bool isDown);

    ToolChoice& tools_;
    HoverTracker hover_;
    Canvas canvas_;
    FlaggedSpots spots_;
    std::optional<WorstSpot> shown_;
    std::optional<SeamDot> dot_;
    std::weak_ptr<const Scene> painted_;
    QPointF pressed_;
    Press press_ = Press::None;
    Qt::MouseButton button_ = Qt::NoButton;  ///< the pressed one
    bool twice_ = false;                     ///< the press is a double click so far
    /// Frames everything at every view size until the user moves the camera.
    bool followsAll_ = true;
};

}  // namespace toile::app
