// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/base/worker.h"
#include "app/views/tool.h"
#include "app/views/tools/cloth_snapper.h"
#include "app/views/tools/path_draft.h"
#include "core/cut/user_cuts.h"
#include "core/pattern/mirrored_edit.h"

namespace toile::app {

class Workspace;

/// A cut that is being drawn, and what its mirror image follows from.
struct DraftedCut {
    std::shared_ptr<const Garment> garment;
    PieceResults results;
    std::shared_ptr<const Symmetry> symmetry;
    UserCut cut;
};

bool isSameQuestion(const DraftedCut& a, const DraftedCut& b);

/// What the tools that draw a cut have in common: clicks set places on one piece, in either view;
/// the way between them is shown while the pointer moves, with its length; Enter or a double click
/// makes the cut, Backspace takes a place back, Escape all of them, and then the tool.
class PathTool : public Tool {
    Q_OBJECT

public:
    void click(ToolView& view, const Pointer& pointer) override;
    void doubleClick(ToolView& view, const Pointer& pointer) override;
    void hover(ToolView& view, const Pointer& pointer) override;
    void leave(ToolView& view) override;
    bool speaks() const override { return true; }
    bool wants(const QKeyEvent& event) const override;
    void key(ToolView& view, const QKeyEvent& event) override;
    void cancel() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;
    Qt::CursorShape cursor(ViewKind) const override { return Qt::CrossCursor; }

    const PathDraft& draft() const { return draft_; }
    /// The mirror image of what is drawn, where it is shown.
    const std::optional<CutImage>& image() const { return image_; }

protected:
    PathTool(Workspace& workspace, PathFinder& finder, UserCut::Kind kind, std::size_t least);

    /// The place that the pointer means, if any.
    std::optional<ClothPoint> placeAt(const ToolView& view, const Pointer& pointer);
    /// True where the place can be added: of the same piece, and not the last one again.
    virtual bool fits(const ClothPoint& point) const;
    void add(const ClothPoint& point);
    /// Whether a click with Alt, where nothing is begun, cuts around the tube there.
    virtual bool goesAround() const { return false; }
    void follow(ToolView& view, const Pointer& pointer, const std::optional<ClothPoint>& at);
    bool hasEnough() const { return draft_.points().size() >= least_; }
    /// Orders the cut and begins anew; where the cut bends with a way that is still being looked
    /// for, once that is known.
    virtual void finish();
    /// Said of a place on another piece than those before.
    virtual QString elsewhere() const;
    /// What is wrong with the place under the pointer, or has to be done there; usually nothing.
    virtual QString remark(const ClothPoint&) const { return {}; }
    /// As what a dart that begins at an earlier cut has to be cut.
    virtual UserCut::Kind kindFor(const std::vector<ClothPoint>&) { return kind_; }

    Workspace& workspace_;
    PathDraft draft_;
    ClothSnapper snapper_;
    UserCut::Kind kind_;

private:
    void finishWhenKnown();
    /// Looks for the mirror image of what is drawn so far, where edits are mirrored.
    void findImage();
    /// Whether the cut has to bend as the ways do.
    bool bends() const;
    std::vector<Eigen::Vector3d> cutPoints();
    /// Whether a way between two places is far longer than the straight line: it may run over
    /// another layer of the cloth than the one that is meant.
    bool isDetour() const;

    std::size_t least_;  ///< places that a cut needs
    Follower<DraftedCut, std::optional<CutImage>> images_;
    std::optional<CutImage> image_;    ///< of what is drawn, shown as a preview
    std::optional<ClothPoint> under_;  ///< the pointer, before the first place
    QPointF pointer_;
    ViewKind pointerView_ = ViewKind::Garment;
    bool isInView_ = false;
    bool isMeant_ = false;  ///< the last click has set a place, or was at the last one again
    bool isFinishing_ = false;
    QString remark_;
};

}  // namespace toile::app
