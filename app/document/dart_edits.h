// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/symmetry/symmetry.h"

namespace toile::app {

/// What a person decides of darts, one edit each; the rest of the settings stays. All pure.

/// What has been said of a dart. @param dart  index into Garment::seams
DartSettings saidOfDart(const Garment& garment, const LineSettings& lines, int dart);

/// With this intake, mm, of a dart and of the one that mirrors it; none: as the cloth lies.
/// @param symmetry  null: edits are not mirrored
LineSettings withIntake(LineSettings lines, const Garment& garment, int dart,
                        std::optional<double> intake, const Symmetry* symmetry);

/// Laid over this leg, its mirror image over the one that mirrors it; none: by convention.
LineSettings withLay(LineSettings lines, const Garment& garment, int dart,
                     std::optional<DartLay> lay, const Symmetry* symmetry);

}  // namespace toile::app
