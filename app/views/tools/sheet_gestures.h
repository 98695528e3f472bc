// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/views/tool.h"
#include "core/layout/snapping.h"

namespace toile::app {

/// A drag in the pattern view, from press to release. Its changes form one undo step; taken back,
/// it leaves none.
class SheetGesture {
public:
    virtual ~SheetGesture() = default;

    /// True if pieces or flat points have changed since the press. Its data then refers to pieces
    /// that are gone or have other coordinates.
    bool isStale() const {
        return garment_ != document_.garment() || results_ != document_.results();
    }

    /// The pointer has moved with the button down, beyond the start drag distance.
    virtual void drag(ToolView& view, const Pointer& pointer) = 0;
    /// Restores the state before the press.
    virtual void takeBack() = 0;
    virtual void paint(const ToolView&, QPainter&, const RenderStyle&) const {}

protected:
    explicit SheetGesture(Document& document)
        : document_(document), garment_(document.garment()), results_(document.results()) {}

    Document& document_;

private:
    std::shared_ptr<const Garment> garment_;
    PieceResults results_;
};

/// Selects the pieces that touch a box drawn with the pointer.
class BoxGesture : public SheetGesture {
public:
    /// @param pressed  sheet position under the pointer
    /// @param adds     keeps the current selection
    BoxGesture(Document& document, const Eigen::Vector2d& pressed, bool adds);

    void drag(ToolView& view, const Pointer& pointer) override;
    void takeBack() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    Document::Selection before_;
    bool adds_;
    Eigen::Vector2d from_, to_;  ///< corners on the sheet, because the view may move
};

/// Base of gestures that place the selected pieces.
class PlacingGesture : public SheetGesture {
public:
    void takeBack() override;

protected:
    /// @param text  name of the undo step
    PlacingGesture(Document& document, QString text);
    void lay(const PiecePlacements& placements);
    /// Whether the drag snaps; Alt inverts the setting.
    bool snaps(const Pointer& pointer) const;

    const std::vector<int> pieces_;
    PiecePlacements before_;
    QPointF pointer_;

private:
    QString text_;
    int gesture_;
    std::vector<PieceSettings> settingsBefore_;
};

/// Moves the pieces with the pointer, with optional snapping.
class MoveGesture : public PlacingGesture {
public:
    /// @param pressed  sheet position under the pointer
    MoveGesture(Document& document, const Eigen::Vector2d& pressed);

    void drag(ToolView& view, const Pointer& pointer) override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    Eigen::Vector2d pressed_;
    Eigen::AlignedBox2d box_;          ///< bounding box of the moved pieces, before
    Points2 corners_ = Points2(0, 2);  ///< of the moved pieces, before
    SnapTargets targets_;
    SnappedMove move_;
};

/// Turns the pieces together around the middle of their bounding box. Shift: in steps of 15
/// degrees. With snapping on, a single piece snaps to right angles and to where its grain or a
/// straight edge is parallel to the sheet.
class RotateGesture : public PlacingGesture {
public:
    RotateGesture(Document& document, const Eigen::Vector2d& pressed);

    void drag(ToolView& view, const Pointer& pointer) override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    double snapped(double turn, const Pointer& pointer) const;

    Eigen::Vector2d centre_;
    double from_;  ///< pointer direction at the press, radians
    double turn_ = 0;
    /// Turns modulo 180 degrees that align the grain or an edge of a single piece with the sheet.
    std::vector<double> good_;
};

}  // namespace toile::app
