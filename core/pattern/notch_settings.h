// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/words.h"
#include "core/garment/seam.h"

namespace toile {

/// What a notch is cut or drawn as (notch_mark.h).
enum class NotchForm { Slit, V, T, Castle };

/// What they are called in project files.
inline constexpr Word<NotchForm> kNotchFormWords[] = {{NotchForm::Slit, "slit"},
                                                      {NotchForm::V, "v"},
                                                      {NotchForm::T, "t"},
                                                      {NotchForm::Castle, "castle"}};

/// A notch that a person has added or taken away: a place on either line of a seam, as a share of
/// it, so that it stays wherever the seam is cut. One that is dragged is taken away and added.
struct NotchSettings {
    LineId line;
    double at = 0;
    bool reversed = false;       ///< of the side of the line that runs against it
    bool isThere = true;         ///< false: the one next to the place is taken away
    std::optional<int> count{};  ///< 1 or 2; none: by convention (Notch::count)

    bool operator==(const NotchSettings&) const = default;
};

/// Everything a person has decided about notches.
struct NotchRules {
    bool automatic = true;  ///< false: only those said below
    NotchForm form = NotchForm::Slit;
    double depth = 5;  ///< from the cutting line inwards, mm
    std::vector<NotchSettings> notches{};

    bool operator==(const NotchRules&) const = default;
};

}  // namespace toile
