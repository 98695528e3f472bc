// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "app/document/view_state.h"
#include "app/render/overlay_values.h"

namespace toile::app {

class Document;

/// What a person wants to know of what the pointer is on: "front / back · 412.3 / 412.3 mm, Δ 0.0",
/// "front · 251.2 cm²"; where the overlay shows a number, of a piece and a vertex that at the
/// place: "front · Strain along warp +1.8 % (limit +2 %)".
/// @param place  under the pointer; none: no number
/// Cost: linear in the outlines of a seam's pieces; of a piece that is not flat in its triangles.
QString featureText(const Document& document, const Feature& feature,
                    const std::optional<SurfaceHit>& place = {});

/// Of the stretch of outline that is selected, as `featureText`; empty where none is, or a seam
/// has been selected since.
QString markedText(const Document& document);

/// The number that the document's overlay shows at a place, in its unit: what the mark on the bar
/// and the label at the pointer say. None where the overlay shows none or the piece is not flat.
/// Cost: linear in the pieces.
std::optional<double> shownValueAt(const Document& document, const SurfaceHit& place);

}  // namespace toile::app
