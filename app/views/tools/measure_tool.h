// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "app/views/tool.h"
#include "app/views/tools/cloth_snapper.h"
#include "app/views/tools/path_draft.h"
#include "core/garment/piece.h"
#include "core/mesh/mesh_arrays.h"

namespace toile::app {

/// A length on the garment and in the pattern, mm.
struct MeasuredLength {
    double onCloth = 0;
    std::optional<double> flat{};  ///< only if the piece is flat

    /// Relative difference of the flat length to the length on the cloth.
    std::optional<double> difference() const {
        return flat && onCloth > 0 ? std::optional(*flat / onCloth - 1) : std::nullopt;
    }
};

/// Straight distance in the pattern.
double flatDistance(const Piece& piece, const Points2& Q, const SurfacePoint& from,
                    const SurfacePoint& to);

/// Length along the outline or the edge of a hole, on the side that is shorter on the garment.
/// Nullopt if the places are not on the same loop.
/// @param Q  the piece's flat points; null if it is not flat
std::optional<MeasuredLength> alongOutline(const Piece& piece, const Points2* Q,
                                           const SurfacePoint& from, const SurfacePoint& to);

class Document;

/// Measures between places on one piece: over the cloth, straight in the pattern, and along the
/// outline if both ends are on it. Changes nothing.
class MeasureTool : public Tool {
    Q_OBJECT

public:
    MeasureTool(Document& document, PathFinder& finder);

    ToolId id() const override { return ToolId::Measure; }
    QString hint(ViewKind view) const override;
    Qt::CursorShape cursor(ViewKind) const override { return Qt::CrossCursor; }
    void click(ToolView& view, const Pointer& pointer) override;
    void doubleClick(ToolView& view, const Pointer& pointer) override;
    void hover(ToolView& view, const Pointer& pointer) override;
    void leave(ToolView& view) override;
    bool speaks() const override { return true; }
    bool wants(const QKeyEvent& event) const override;
    void key(ToolView& view, const QKeyEvent& event) override;
    void cancel() override;
    void paint(const ToolView& view, QPainter& painter, const RenderStyle& style) const override;

    /// Length over the cloth; nullopt until all paths are found.
    std::optional<MeasuredLength> way() const;
    /// Length between two places on one outline.
    std::optional<MeasuredLength> outline() const;
    /// The lines of the note.
    QStringList lines() const;

private:
    /// The places set, and the one under the pointer.
    std::vector<ClothPoint> places() const;
    const Points2* flat() const;

    Document& document_;
    PathDraft draft_;
    ClothSnapper snapper_;
    std::optional<ClothPoint> under_;
    bool isEnded_ = false;  ///< the measurement is kept until the next click
    QPointF pointer_;
    ViewKind pointerView_ = ViewKind::Garment;
};

}  // namespace toile::app
