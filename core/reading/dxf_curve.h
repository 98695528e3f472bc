// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/reading/dxf_document.h"
#include "core/reading/pattern_file.h"

namespace toile {

/// How far a chord may be from the curve that it stands for, mm. All chords of a full circle are
/// shorter than it by about twice as much, whatever its radius.
inline constexpr double kCurveTolerance = 0.005;

/// The line that an entity draws, in the coordinates of the drawing or of its block: LINE,
/// LWPOLYLINE, POLYLINE (with bulges, curve-fit and spline-fit ones too), ARC, CIRCLE, ELLIPSE,
/// SPLINE by control points or by fit points. Closed lines do not repeat their first point.
/// Nothing for other entities, and for lines that cannot be read: in a tilted plane, meshes,
/// splines whose numbers do not fit together.
/// @param unit  about how many mm one of the entity's units is in the end, for the tolerance
/// Cost: linear in the points. Pure.
std::optional<FileLine> dxfCurve(const DxfEntity& entity, double unit);

}  // namespace toile
