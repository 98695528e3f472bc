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

/// Tells the document what the pointer is on in a view, and the person by a label beside the
/// pointer. The label is a widget of its own: it moves without painting the view again.
class HoverTracker {
public:
    /// @param widget the view, which outlives this object and owns the label
    HoverTracker(Document& document, QWidget& widget);

    /// The pointer moves in the view without a button.
    /// @param tells  whether the label is shown: not where something else is written there
    /// @return the cloth under the pointer: that of a vertex where the pointer is on one
    std::optional<SurfaceHit> move(const ToolView& view, const QPointF& at, bool tells = true);
    /// True while it has something under the pointer.
    bool isOn() const { return shown_.has_value(); }
    /// It has left, or does something else.
    void leave();
    /// What the document is told elsewhere: a label about something else goes.
    void follow();
    /// What is there to be said of it may be another now.
    void writeAgain();
    /// What the label is about is no more.
    void reset();

private:
    void write();
    void hideLabel();
    void placeLabel(const QPoint& pointer);
    /// Where the label was there is the view again.
    void uncover(const QRect& left);

    Document& document_;
    QWidget& widget_;
    QLabel* label_;
    std::optional<Feature> shown_;     ///< what the label is about
    std::optional<SurfaceHit> place_;  ///< of the cloth under the pointer
};

/// Dots on the vertices that are selected or under the pointer.
void paintVertexDots(QPainter& painter, const RenderStyle& style, const ToolView& view,
                     const Document& document);

}  // namespace toile::app
