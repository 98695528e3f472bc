// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "app/marker/cloth_drag.h"
#include "app/views/canvas.h"
#include "app/views/tool.h"
#include "core/marker/cloth_marker.h"

class QPainter;

namespace toile::app {

class MarkerDesk;

struct RenderStyle;

/// A copy as it is painted.
struct ClothShape {
    Points2 edge, seam;  ///< as it lies; the seam line is empty where it is cut along that
    Eigen::Vector2d label = Eigen::Vector2d::Zero();
    Eigen::Vector2d grain = Eigen::Vector2d::UnitX();  ///< along the warp of the piece
    QColor colour;
    QString name;
    bool isKept = false, isMisplaced = false, isSelected = false, isStated = false;
};

/// Where names go, found once for each piece of a pattern.
class ClothLabels {
public:
    /// On the piece, as far from its edge as may be.
    const Eigen::Vector2d& of(const std::shared_ptr<const Pattern>& pattern, int piece);

private:
    std::shared_ptr<const Pattern> pattern_;
    std::vector<std::optional<Eigen::Vector2d>> places_;
};

/// The cloth: its edges, where it is folded, its stripes, how long it is.
void paintCloth(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothMarker& marker, const MarkerSettings& settings, const QColor& ground);

/// The copies; those that are selected or misplaced over the others.
void paintCopies(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                 const std::vector<ClothShape>& shapes);

/// As it is painted where something lies on another thing, or beyond the cloth.
QColor misplacedColour();

/// The cloth with the copies that lie on it. A copy that is dragged or turned is kept where it was
/// put. The warp runs to the right. Other drags, the wheel and keys move the picture (Canvas).
class ClothView : public QWidget {
    Q_OBJECT

public:
    /// `desk` must outlive this.
    explicit ClothView(MarkerDesk& desk, QWidget* parent = nullptr);

    /// Shows the whole cloth, and keeps doing so until the picture is moved.
    void frameAll() { camera_.frameAll(); }
    /// Where the middle of a copy's name is, logical pixels.
    QPointF placeOf(int copy) const;
    /// Of the selected copy, by which it is turned; none where the cloth does not allow that.
    std::optional<QPointF> handle() const;
    /// -1: none.
    int selected() const;
    bool isDragging() const { return drag_ || turning_; }

signals:
    /// What a person should know of what was asked for; empty: nothing.
    void said(const QString& sentence);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// Turning by the handle.
    struct Turning {
        LaidCopy before{};
        double from = 0;  ///< direction from the middle to the pointer at first
        Eigen::Vector2d middle{0, 0};
        Placement now{};
    };

    void refresh();
    SheetMap map() const { return SheetMap(camera_.camera()); }
    bool isOnHandle(const QPointF& at) const;
    Eigen::Vector2d onCloth(const QPointF& at) const;
    int copyAt(const QPointF& at) const;
    void select(int copy);
    int pieceOf(const LaidCopy& copy) const;
    void turnSelected(bool clockwise);
    void dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers);
    void endDrag();
    void cancelDrag();
    void showMenu(const QPoint& at, int copy);
    void updateCursor(const QPointF& at);
    void paintHandles(QPainter& painter, const RenderStyle& style) const;

    MarkerDesk& desk_;
    SheetCamera camera_;
    Canvas canvas_;
    ClothLabels labels_;
    std::vector<ClothShape> shapes_;   ///< as the desk's copies
    std::optional<CopyKey> selected_;  ///< which is the one that is dragged, too
    QPointF pressed_;
    bool isHeld_ = false;
    std::optional<ClothDrag> drag_;
    std::optional<Turning> turning_;
    std::optional<Placement> dragged_;
};

}  // namespace toile::app
