// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iterator>

#include "app/document/view_state.h"
#include "core/base/words.h"

namespace toile {

/// What the overlays are called on the command line and in project files. Once released they stay.
inline constexpr Word<Overlay> kOverlayWords[] = {
    {Overlay::None, "none"},           {Overlay::Checker, "checker"},
    {Overlay::Area, "area"},           {Overlay::Angle, "angle"},
    {Overlay::Strain, "strain"},       {Overlay::Warp, "warp"},
    {Overlay::Weft, "weft"},           {Overlay::Bias, "bias"},
    {Overlay::Principal, "principal"}, {Overlay::Dirichlet, "dirichlet"},
};
static_assert(std::size(kOverlayWords) == kOverlayCount, "each overlay needs a word");

}  // namespace toile
