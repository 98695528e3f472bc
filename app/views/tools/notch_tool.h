// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "app/document/line_edits.h"
#include "app/views/tool.h"

namespace toile::app {

class Document;

/// Edits notches on both sides of a seam at once: a click on a seam adds one, a drag moves one,
/// Ctrl+click or Delete removes one. Highlights the seam under the pointer and its notches in both
/// views. A drag becomes one undo step when it ends.
class NotchTool : public Tool {
    Q_OBJECT

public:
    explicit NotchTool(Document& document) : document_(document) {}

    ToolId id() const override { return ToolId::Notch; }
    QString hint(ViewKind view) const override;
    Qt::CursorShape cursor(ViewKind view) const override;
    bool press(ToolView& view, const Pointer& pointer) override;
    void drag(ToolView& view, const Pointer& pointer) override;
    void release(ToolView& view, const Pointer& pointer) override;
    void click(ToolView& view, const Pointer& pointer) override;
    void hover(ToolView& view, const Pointer& pointer) override;
    void leave(ToolView& view) override;
    bool speaks() const override { return true; }
    bool wants(const QKeyEvent& event) const override;
    void key(ToolView& view, const QKeyEvent& event) override;
    void cancel() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

    const std::optional<NotchAt>& selected() const { return selected_; }

private:
    /// A seam under the pointer, or a notch on it.
    struct Pointed : NotchAt {
        bool isNotch = false;

        bool operator==(const Pointed&) const = default;
    };
    struct Moving {
        SeamNotch notch;
        double share = 0;  ///< current position
        QPointF pressed;
        bool removes = false;  ///< on release, unless it was dragged
        bool moved = false;
    };
    /// A notch as drawn on a piece, from the seam line to the cutting line, in the piece's
    /// coordinates.
    struct Mark {
        NotchAt at;
        int piece = -1;
        Eigen::Vector2d foot, head;
    };

    std::optional<Pointed> pointedAt(const ToolView& view, const QPointF& at) const;
    std::optional<NotchAt> markAt(const ToolView& view, const QPointF& at) const;
    const std::vector<Mark>& marks() const;
    const std::vector<SeamNotch>& notches() const;
    void find() const;
    /// The notch in the pattern; nullopt if it no longer exists.
    std::optional<SeamNotch> known(const NotchAt& at) const;
    /// The notch that Delete would remove.
    std::optional<SeamNotch> target() const;
    void show(const std::optional<Pointed>& pointed);
    void remove(const SeamNotch& notch);
    void paintSpot(const ToolView& view, QPainter& painter, const RenderStyle& style,
                   const NotchAt& at, bool filled, bool strong) const;

    Document& document_;
    std::optional<Pointed> hovered_;
    std::optional<NotchAt> selected_;
    std::optional<Moving> moving_;
    QPointF pointer_;
    ViewKind pointerView_ = ViewKind::Pattern;
    // Cached for one pattern.
    mutable std::weak_ptr<const Pattern> of_;
    mutable std::vector<Mark> marks_;
    mutable std::vector<SeamNotch> notches_;
};

}  // namespace toile::app
