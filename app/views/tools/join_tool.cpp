// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/tools/join_tool.h"

#include <QPainter>

#include "app/document/document.h"
#include "app/render/render_style.h"
#include "app/session/workspace.h"
#include "app/text/figures.h"
#include "app/views/tools/tool_paint.h"

namespace toile::app {

namespace {

/// Picking distance of a seam, pixels.
constexpr double kSeamRadius = 8;

}  // namespace

QString JoinTool::hint(ViewKind) const {
    return tr("Click a seam: join the cloth on both sides · Esc: leave the tool");
}

std::optional<int> JoinTool::seamAt(const ToolView& view, const Pointer& pointer) const {
    const auto& garment = workspace_.document().garment();
    if (!garment) {
        return std::nullopt;
    }
    const auto hit = view.seamHitAt(pointer.at, kSeamRadius, [&garment](int seam) -> bool {
        const auto at = static_cast<std::size_t>(seam);
        // For a moment, the scene may belong to the previous garment.
        return at < garment->seams.seams.size() && garment->seams.seams[at].kind != SeamKind::Free;
    });
    return hit ? std::optional(hit->seam) : std::nullopt;
}

void JoinTool::show(std::optional<int> seam) {
    if (seam_ != seam) {
        seam_ = seam;
        emit changed();
    }
}

void JoinTool::hover(ToolView& view, const Pointer& pointer) {
    pointer_ = pointer.at;
    pointerView_ = view.kind();
    show(seamAt(view, pointer));
    if (seam_) {
        view.repaintSoon();  // the label follows the pointer
    }
}

void JoinTool::leave(ToolView&) {
    show(std::nullopt);
}

void JoinTool::click(ToolView& view, const Pointer& pointer) {
    if (const auto seam = seamAt(view, pointer)) {
        workspace_.cuts().joinSeam(*seam);
    }
}

QStringList JoinTool::note() const {
    const Document& document = workspace_.document();
    const Seam& seam = document.garment()->seams.seams[static_cast<std::size_t>(*seam_)];
    return {seamName(document, *seam_), lengthWithUnit(seam.length3d[0])};
}

void JoinTool::paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const {
    const auto& garment = workspace_.document().garment();
    if (!seam_ || !garment || *seam_ >= workspace_.document().seamCount()) {
        return;
    }
    painter.save();
    for (const QPolygonF& line : view.seamOnScreen(*seam_)) {
        painter.setPen(QPen(style.seamHalo, 6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
        painter.setPen(QPen(style.seam, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    }
    painter.restore();
    if (view.kind() == pointerView_) {
        paintNote(painter, style, pointer_, note());
    }
}

}  // namespace toile::app
