// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/words.h"
#include "core/flatten/flatten.h"

namespace toile {

/// What the choices of a flattening are called on the command line and in project files. Once
/// released they stay.

inline constexpr Word<Quality> kQualityWords[] = {
    {Quality::Draft, "draft"}, {Quality::Standard, "standard"}, {Quality::Fine, "fine"}};
inline constexpr Word<FreeBoundary> kFreeBoundaryWords[] = {{FreeBoundary::Pinned, "pinned"},
                                                            {FreeBoundary::Spectral, "spectral"}};
inline constexpr Word<StretchOutline> kStretchOutlineWords[] = {
    {StretchOutline::Circle, "circle"}, {StretchOutline::Curvature, "curvature"}};

}  // namespace toile
