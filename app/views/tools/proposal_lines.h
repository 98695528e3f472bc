// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/views/tool.h"

namespace toile::app {

class CutProposals;
class Document;

/// Proposed cuts over the worn garment: dashed lines, the selected one with its name and its
/// handles, which a drag moves. Logical pixels. Each question costs a ray for each place that lines
/// are drawn through.
class ProposalLines {
public:
    ProposalLines(CutProposals& proposals, const Document& document)
        : proposals_(proposals), document_(document) {}

    /// Whether there is anything to see.
    bool areShown(const ToolView& view) const;
    /// @return whether the press has taken hold of a handle
    bool press(const ToolView& view, const QPointF& at);
    /// False also where an answer or a cut has taken the proposals away under the pointer.
    bool isHeld() const;
    /// Requires `isHeld`.
    void drag(const ToolView& view, const QPointF& at);
    void release();
    void cancel();
    /// Selects the line under the pointer. @return false where there is none
    bool select(const ToolView& view, const QPointF& at);
    /// @return whether another handle, or none, is under the pointer now
    bool hover(const ToolView& view, const QPointF& at);
    bool leave();
    bool isOverHandle() const { return hovered_.has_value(); }
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const;

private:
    struct Handle {
        std::size_t cut;
        int point;
        bool operator==(const Handle&) const = default;
    };
    /// A line over the cloth, finely divided.
    struct Line {
        std::vector<Eigen::Vector3d> points;  ///< of the cut: while these are the same it stays
        std::vector<Eigen::Vector3d> drawn;
    };

    const std::vector<Line>& lines() const;
    std::optional<Handle> handleAt(const ToolView& view, const QPointF& at) const;
    std::optional<std::size_t> lineAt(const ToolView& view, const QPointF& at) const;
    void paintLine(const ToolView& view, QPainter& painter, const RenderStyle& style,
                   std::size_t cut) const;

    CutProposals& proposals_;
    const Document& document_;
    std::optional<Handle> held_, hovered_;
    mutable std::vector<Line> lines_;
};

}  // namespace toile::app
