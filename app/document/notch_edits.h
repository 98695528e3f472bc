// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/pattern.h"

namespace toile::app {

/// What a person decides of notches, one edit each; the rest of the settings stays. What is said of
/// a notch holds on both sides of its seam, and for the seam that mirrors it. All pure; each costs
/// the outlines of the garment.

/// A notch on a seam: one place, whichever side it is shown on.
struct NotchAt {
    int seam = -1;     ///< index into Garment::seams
    double share = 0;  ///< of its length, from its start

    bool operator==(const NotchAt&) const = default;
};

/// The pattern's notches, each once, by seam and share.
struct SeamNotch : NotchAt {
    NotchReason reason = NotchReason::Balance;
};
std::vector<SeamNotch> notchesOf(const Pattern& pattern);

/// With a notch there; of lines without notches all that come by themselves are there then too.
LineSettings withNotch(LineSettings lines, const Garment& garment, const NotchAt& at);
/// Without this one. What a person has placed is forgotten, what comes by itself is kept away.
/// @param symmetry  that notches are mirrored by; may be null
LineSettings withoutNotch(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                          const Symmetry* symmetry);
/// With this one at another share of its seam.
LineSettings withNotchMoved(LineSettings lines, const Garment& garment, const SeamNotch& notch,
                            double share, const Symmetry* symmetry);

}  // namespace toile::app
