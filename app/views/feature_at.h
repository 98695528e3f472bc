// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <optional>

#include "app/document/view_state.h"

namespace toile::app {

class Document;
class ToolView;
struct Pointer;

/// What lies under a pixel of a view: a vertex where the triangles are seen so large that one can
/// be meant, else a seam line or free edge a few pixels off, else the piece.
/// Cost: well under 10 ms with a million triangles.
std::optional<Feature> featureAt(const ToolView& view, const Document& document, const QPointF& at);

/// The stretch of outline between two corners at the seam line under a pixel.
std::optional<Feature> runAt(const ToolView& view, const Document& document, const QPointF& at);

/// Selects the vertex or seam under a pixel. @return false where there is neither
bool selectLineAt(const ToolView& view, Document& document, const QPointF& at);
/// Selects the piece under the pointer, or adds it and takes it out; beside all nothing is
/// selected.
void selectPieceAt(const ToolView& view, Document& document, const Pointer& pointer);
/// Selects the stretch between corners, and the seam that is the whole of it. @return false where
/// there is no line
bool selectRunAt(const ToolView& view, Document& document, const QPointF& at);

}  // namespace toile::app
