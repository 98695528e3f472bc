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

/// A copy to paint.
struct ClothShape {
    Points2 edge, seam;  ///< in place; the seam line is empty if the piece is cut along it
    Eigen::Vector2d label = Eigen::Vector2d::Zero();
    Eigen::Vector2d grain = Eigen::Vector2d::UnitX();  ///< along the warp of the piece
    QColor colour;
    QString name;
    bool isKept = false, isMisplaced = false, isSelected = false, isStated = false;
};

/// Label positions, computed once for each piece of a pattern.
class ClothLabels {
public:
    /// A point on the piece, as far from its edge as possible.
    const Eigen::Vector2d& of(const std::shared_ptr<const Pattern>& pattern, int piece);

private:
    std::shared_ptr<const Pattern> pattern_;
    std::vector<std::optional<Eigen::Vector2d>> places_;
};

/// Paints the cloth: edges, fold, stripes and length.
void paintCloth(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothMarker& marker, const MarkerSettings& settings, const QColor& ground);

/// Paints the copies, with selected and misplaced ones on top.
void paintCopies(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                 const std::vector<ClothShape>& shapes);

/// Marks copies that overlap others or exceed the cloth.
QColor misplacedColour();

/// The cloth with its copies. Dragging or turning a copy fixes it in the new place. The warp runs
/// to the right. Other drags, the wheel and keys move the picture (Canvas).
class ClothView : public QWidget {
    Q_OBJECT

public:
    /// `desk` must outlive this.
    explicit ClothView(MarkerDesk& desk, QWidget* parent = nullptr);

    /// Shows the whole cloth until the user moves the picture.
    void frameAll() { camera_.frameAll(); }
    /// Middle of a copy's name, logical pixels.
    QPointF placeOf(int copy) const;
    /// Turning handle of the selected copy; nullopt if the cloth does not allow turning.
    std::optional<QPointF> handle() const;
    /// -1: none.
    int selected() const;
    bool isDragging() const { return drag_ || turning_; }

signals:
    /// A message for the user about the last action; empty: none.
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
        double from = 0;  ///< initial direction from the middle to the pointer
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
    std::vector<ClothShape> shapes_;   ///< parallel to the desk's copies
    std::optional<CopyKey> selected_;  ///< also the dragged copy
    QPointF pressed_;
    bool isHeld_ = false;
    std::optional<ClothDrag> drag_;
    std::optional<Turning> turning_;
    std::optional<Placement> dragged_;
};

}  // namespace toile::app
