// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <optional>

#include "app/document/view_state.h"

namespace toile::app {

class Document;
class ToolView;
struct Pointer;

/// Finds the feature under a pixel: a vertex if triangles appear large enough to aim at one, else a
/// seam line or free edge within a few pixels, else the piece.
/// Cost: well under 10 ms with a million triangles.
std::optional<Feature> featureAt(const ToolView& view, const Document& document, const QPointF& at);

/// The stretch of outline between two corners that contains the seam line under a pixel.
std::optional<Feature> runAt(const ToolView& view, const Document& document, const QPointF& at);

/// Selects the vertex or seam under a pixel. @return false if there is none
bool selectLineAt(const ToolView& view, Document& document, const QPointF& at);
/// Selects the piece under the pointer, or toggles it (`Pointer::adds`). Off the pieces it clears
/// the selection.
void selectPieceAt(const ToolView& view, Document& document, const Pointer& pointer);
/// Selects the stretch between corners, and the seam if it covers the whole stretch.
/// @return false if there is no line
bool selectRunAt(const ToolView& view, Document& document, const QPointF& at);

}  // namespace toile::app
