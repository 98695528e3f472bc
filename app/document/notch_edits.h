// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"

namespace toile::app {

/// Edits of notches, one function each; other settings stay. An edit applies to both sides of the
/// seam, and to the seam that mirrors it. All pure; each costs the outlines of the garment.

/// A notch on a seam, whichever side it is shown on.
struct NotchAt {
    int seam = -1;     ///< index into Garment::seams
    double share = 0;  ///< of the seam's length, from its start

    bool operator==(const NotchAt&) const = default;
};

/// The pattern's notches, each once, by seam and share.
struct SeamNotch : NotchAt {
    NotchReason reason = NotchReason::Balance;
};
std::vector<SeamNotch> notchesOf(const Pattern& pattern);

/// Adds a notch; in lines without notches all automatic ones are added, too.
LineSettings withNotch(LineSettings lines, const Garment& garment, const NotchAt& at);
/// Removes a notch: deletes one that the user placed, and suppresses an automatic one.
/// @param symmetry  mirrors notches; may be null
LineSettings withoutNotch(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                          const Symmetry* symmetry);
/// Moves a notch to another share of its seam.
LineSettings withNotchMoved(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                            double share, const Symmetry* symmetry);

}  // namespace toile::app
