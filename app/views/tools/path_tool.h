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

/// A cut being drawn, and the data needed for its mirror image.
struct DraftedCut {
    std::shared_ptr<const Garment> garment;
    PieceResults results;
    std::shared_ptr<const Symmetry> symmetry;
    UserCut cut;
};

bool isSameQuestion(const DraftedCut& a, const DraftedCut& b);

/// Base of the tools that draw a cut. Clicks set places on one piece, in either view. The path and
/// its length are shown while the pointer moves. Enter or a double click makes the cut. Backspace
/// removes a place; Escape removes all, then leaves the tool.
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
    /// The displayed mirror image of the draft, if any.
    const std::optional<CutImage>& image() const { return image_; }

protected:
    PathTool(Workspace& workspace, PathFinder& finder, UserCut::Kind kind, std::size_t least);

    /// The place under the pointer, if any.
    std::optional<ClothPoint> placeAt(const ToolView& view, const Pointer& pointer);
    /// True if the place can be added: on the same piece and not a repetition.
    virtual bool fits(const ClothPoint& point) const;
    void add(const ClothPoint& point);
    /// Whether Alt+click cuts around a tube if nothing is begun.
    virtual bool goesAround() const { return false; }
    void follow(ToolView& view, const Pointer& pointer, const std::optional<ClothPoint>& at);
    bool hasEnough() const { return draft_.points().size() >= least_; }
    /// Makes the cut and starts over. If the cut follows the paths and a search is running, waits
    /// for its result.
    virtual void finish();
    /// The note for a place on another piece.
    virtual QString elsewhere() const;
    /// A problem with the place under the pointer, or an instruction; usually empty.
    virtual QString remark(const ClothPoint&) const { return {}; }
    /// The kind for a dart that begins at an earlier cut.
    virtual UserCut::Kind kindFor(const std::vector<ClothPoint>&) { return kind_; }

    Workspace& workspace_;
    PathDraft draft_;
    ClothSnapper snapper_;
    UserCut::Kind kind_;

private:
    void finishWhenKnown();
    /// Computes the mirror image of the draft, if edits are mirrored.
    void findImage();
    /// Whether the cut has to follow the bends of the paths.
    bool bends() const;
    std::vector<Eigen::Vector3d> cutPoints();
    /// Whether a path is far longer than the straight line. It may then run over another layer of
    /// the cloth than intended.
    bool isDetour() const;

    std::size_t least_;  ///< places needed for a cut
    Follower<DraftedCut, std::optional<CutImage>> images_;
    std::optional<CutImage> image_;    ///< of the draft, shown as a preview
    std::optional<ClothPoint> under_;  ///< place under the pointer, before the first is set
    QPointF pointer_;
    ViewKind pointerView_ = ViewKind::Garment;
    bool isInView_ = false;
    bool isMeant_ = false;  ///< the last click set a place or repeated the last one
    bool isFinishing_ = false;
    QString remark_;
};

}  // namespace toile::app
