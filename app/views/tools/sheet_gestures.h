// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/document/document.h"
#include "app/document/layout.h"
#include "app/views/tool.h"
#include "core/layout/snapping.h"

namespace toile::app {

/// What a drag in the pattern view does, from the press to the release. What it changes is one step
/// of the history; taken back it leaves none.
class SheetGesture {
public:
    virtual ~SheetGesture() = default;

    /// True where other pieces or flat points have come since the press: what it holds is of pieces
    /// that are no more, or lie in other coordinates.
    bool isStale() const {
        return garment_ != document_.garment() || results_ != document_.results();
    }

    /// The pointer has moved with the button down, far enough to be no click.
    virtual void drag(ToolView& view, const Pointer& pointer) = 0;
    /// Everything is to be as before the press.
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

/// Selects the pieces that a box drawn with the pointer touches.
class BoxGesture : public SheetGesture {
public:
    /// @param pressed  place of the sheet under the pointer
    /// @param adds     to what is selected already
    BoxGesture(Document& document, const Eigen::Vector2d& pressed, bool adds);

    void drag(ToolView& view, const Pointer& pointer) override;
    void takeBack() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    Document::Selection before_;
    bool adds_;
    Eigen::Vector2d from_, to_;  ///< corners on the sheet: the view may move meanwhile
};

/// Lays the selected pieces elsewhere.
class PlacingGesture : public SheetGesture {
public:
    void takeBack() override;

protected:
    /// @param text  what is done, for the undo menu
    PlacingGesture(Document& document, QString text);
    void lay(const PiecePlacements& placements);
    /// Whether a drag catches: where snapping is on; Alt turns it the other way round.
    bool snaps(const Pointer& pointer) const;

    const std::vector<int> pieces_;
    PiecePlacements before_;
    QPointF pointer_;

private:
    QString text_;
    int gesture_;
    std::vector<PieceSettings> settingsBefore_;
};

/// Moves them with the pointer, snapping where that is on.
class MoveGesture : public PlacingGesture {
public:
    /// @param pressed  place of the sheet under the pointer
    MoveGesture(Document& document, const Eigen::Vector2d& pressed);

    void drag(ToolView& view, const Pointer& pointer) override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    Eigen::Vector2d pressed_;
    Eigen::AlignedBox2d box_;          ///< around what moves, before
    Points2 corners_ = Points2(0, 2);  ///< of what moves, before
    SnapTargets targets_;
    SnappedMove move_;
};

/// Turns them together about the middle of the box around them. Shift: in steps of 15 degrees;
/// where snapping is on a single piece catches at whole right angles, where its grain or a straight
/// edge runs along the sheet.
class RotateGesture : public PlacingGesture {
public:
    RotateGesture(Document& document, const Eigen::Vector2d& pressed);

    void drag(ToolView& view, const Pointer& pointer) override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

private:
    double snapped(double turn, const Pointer& pointer) const;

    Eigen::Vector2d centre_;
    double from_;  ///< direction of the pointer at the press, radians
    double turn_ = 0;
    /// Turns modulo half a turn after which something of a single piece lies along the sheet.
    std::vector<double> good_;
};

}  // namespace toile::app
