// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "app/document/view_state.h"
#include "app/render/overlay_values.h"

namespace toile::app {

class Document;

/// Describes the feature under the pointer: "front / back · 412.3 / 412.3 mm, Δ 0.0", "front ·
/// 251.2 cm²". For a piece or vertex, adds the overlay's value at the place if there is one: "front
/// · Strain along warp +1.8 % (limit +2 %)".
/// @param place  under the pointer; without it no value is added
/// Cost: linear in the outlines of a seam's pieces, or in the triangles of a piece that is not
/// flat.
QString featureText(const Document& document, const Feature& feature,
                    const std::optional<SurfaceHit>& place = {});

/// Describes the selected stretch of outline like `featureText`. Empty without one, or if a seam
/// was selected afterwards.
QString markedText(const Document& document);

/// The overlay's value at a place, in its unit, as shown on the colour bar and at the pointer.
/// Nullopt if the overlay has no value or the piece is not flat. Cost: linear in the pieces.
std::optional<double> shownValueAt(const Document& document, const SurfaceHit& place);

}  // namespace toile::app
