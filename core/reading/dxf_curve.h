// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/reading/dxf_document.h"
#include "core/reading/pattern_file.h"

namespace toile {

/// Largest distance of a chord from its curve, mm. The chords of a full circle are shorter than the
/// circle by about twice this, whatever its radius.
inline constexpr double kCurveTolerance = 0.005;

/// The line that an entity draws, in the coordinates of the drawing or of its block: LINE,
/// LWPOLYLINE, POLYLINE (with bulges, curve-fit and spline-fit ones too), ARC, CIRCLE, ELLIPSE,
/// SPLINE by control points or by fit points. Closed lines do not repeat their first point. Returns
/// nothing for other entities and for unreadable lines: in a tilted plane, meshes, splines with
/// inconsistent numbers.
/// @param unit  approximate length of the entity's unit in the result, mm; for the tolerance
/// Cost: linear in the points. Pure.
std::optional<FileLine> dxfCurve(const DxfEntity& entity, double unit);

}  // namespace toile
