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

/// A place on a seam: how far along its left side, as in a SeamHit.
struct SeamDot {
    int seam = -1;
    double along = 0;
};

/// A view of the document's scene: gives the pointer to the chosen tool, and to the canvas what no
/// tool takes. Derived views move their camera and paint. Holds a camera and nothing of the
/// garment.
class SceneView : public RenderedWidget, public ToolView, private CanvasCamera {
    Q_OBJECT

public:
    std::vector<QPolygonF> seamOnScreen(int seam) const override;
    std::optional<QPointF> onSeam(int seam, int side, double along) const override;
    void frameSelection() override;
    /// Shows both sides of the selected seam; does nothing where none is selected.
    void frameSeam();
    void frameAll() override;
    /// Shows a place from near by, with a ring around it until the selection or the pieces change.
    void showSpot(const WorstSpot& spot);
    /// The place with the ring, if any.
    const std::optional<WorstSpot>& shownSpot() const { return shown_; }
    void repaintSoon() override { update(); }
    /// True once the present scene is on the screen: for pictures made by the program itself.
    bool isUpToDate() const;
    /// To be marked, as far as they are of what is shown.
    void setWorstSpots(FlaggedSpots spots);
    const FlaggedSpots& spots() const { return spots_; }
    /// The marked spot that is drawn within so many pixels, of several the nearest.
    std::optional<WorstSpot> markedSpotAt(const QPointF& at, double pixels) const;
    /// Marks a place on the left side of a seam.
    void setSeamDot(std::optional<SeamDot> dot);

signals:
    /// What can be done is to be shown: the right button was clicked there and has moved nothing,
    /// or a key asks for it and what is selected is meant.
    void menuWanted(const QPointF& at, bool pointed);
    /// The pointer has come into the view.
    void entered();
    /// What of the cloth the pointer is on; none: nothing, or it has left.
    void pointed(const std::optional<toile::app::SurfaceHit>& hit);

protected:
    SceneView(Document& document, ToolChoice& tools, std::unique_ptr<SceneRenderer> painter,
              QWidget* parent);

    /// Of the scene, as this view draws them.
    virtual const LineRuns& lines() const = 0;
    /// Where a point of a line is drawn; none where it is not.
    virtual std::optional<QPointF> pointOnScreen(const LineVertex& vertex) const = 0;
    virtual void setCameraViewport(double width, double height) = 0;
    /// @param pieces never empty
    virtual void framePieces(const std::set<int>& pieces) = 0;
    /// @return false where nothing of the seam is drawn
    virtual bool frameLines(const SeamScene& seam) = 0;
    /// @param radius mm around the place that are to be seen
    virtual void frameSpot(const WorstSpot& spot, double radius) = 0;
    /// Where a spot is in the view as it is now; none where it is not to be seen.
    virtual std::optional<SpotPlace> placeNow(const WorstSpot& spot) const = 0;
    virtual void turnCamera(const QPointF& delta) { panCamera(delta); }
    virtual void panCamera(const QPointF& delta) = 0;
    virtual void zoomCamera(const QPointF& at, double factor) = 0;
    virtual void paintScene(const RenderStyle& style, int width, int height, double ratio) = 0;
    virtual void paintText(QPainter& painter, const RenderStyle& style) = 0;
    /// By what else lies over the view, logical pixels.
    std::vector<QRectF> covered() const;
    /// A click on something that `paintText` has painted. @return whether it meant anything
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
    /// To be called where the camera has moved without the pointer: what that was on is elsewhere.
    void cameraMoved();
    /// True until the camera is moved by hand.
    bool followsAll() const { return followsAll_; }
    /// To be called where the camera has been set to show something.
    void stopFollowing();
    /// Where the scene's pieces lie on the sheet.
    const SheetPlaces& places() const;
    const ToolChoice& tools() const { return tools_; }
    Document& document_;

private:
    /// What the pressed button does.
    enum class Press { None, Tool, Camera, Overlay };

    void onChanged(const DocumentChange& what);
    void turn(const QPointF& delta) override;
    void pan(const QPointF& delta) override;
    void zoom(const QPointF& at, double factor) override;
    /// The user moves the camera: from here on it stays where it is, unless there is nothing to be
    /// seen yet.
    void takeByHand();
    /// For a press whose release never comes: what it has begun is thrown away.
    void endPress();
    void updateCursor();
    void setSpace(bool isDown);

    ToolChoice& tools_;
    HoverTracker hover_;
    Canvas canvas_;
    FlaggedSpots spots_;
    std::optional<WorstSpot> shown_;
    std::optional<SeamDot> dot_;
    std::shared_ptr<const Scene> painted_;
    QPointF pressed_;
    Press press_ = Press::None;
    Qt::MouseButton button_ = Qt::NoButton;  ///< that is down
    bool twice_ = false;                     ///< the press is the second of two at one place
    /// Until the camera is moved by hand everything stays framed, whatever size the view takes.
    bool followsAll_ = true;
};

}  // namespace toile::app
