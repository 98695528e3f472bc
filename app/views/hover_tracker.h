// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <optional>

#include "app/document/view_state.h"
#include "app/render/overlay_values.h"
#include "app/render/picking.h"

class QLabel;
class QPainter;
class QPoint;
class QRect;
class QWidget;

namespace toile::app {

class Document;
class ToolView;
struct RenderStyle;

/// Reports the hovered feature of a view to the document, and to the user in a label beside the
/// pointer. The label is a separate widget, so moving it does not repaint the view.
class HoverTracker {
public:
    /// @param widget the view, which outlives this object and owns the label
    HoverTracker(Document& document, QWidget& widget);

    /// Handles a pointer move without a button.
    /// @param tells  whether to show the label: false while a tool writes there
    /// @return the hit on the cloth under the pointer, snapped to a hovered vertex
    std::optional<SurfaceHit> move(const ToolView& view, const QPointF& at, bool tells = true);
    /// True while a feature is under the pointer.
    bool isOn() const { return shown_.has_value(); }
    /// The pointer left the view or started another action.
    void leave();
    /// Hides the label if the document's hovered feature comes from elsewhere.
    void follow();
    /// Updates the text after a change of the document.
    void writeAgain();
    /// Forgets the feature because it no longer exists.
    void reset();

private:
    void write();
    void hideLabel();
    void placeLabel(const QPoint& pointer);
    /// Repaints the view where the label was.
    void uncover(const QRect& left);

    Document& document_;
    QWidget& widget_;
    QLabel* label_;
    std::optional<Feature> shown_;     ///< feature described by the label
    std::optional<SurfaceHit> place_;  ///< hit on the cloth under the pointer
};

/// Paints dots on the selected and the hovered vertex.
void paintVertexDots(QPainter& painter, const RenderStyle& style, const ToolView& view,
                     const Document& document);

}  // namespace toile::app
