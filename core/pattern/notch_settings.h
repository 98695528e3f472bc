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

/// Why a notch is where it is.
enum class NotchReason {
    SeamEnd,     ///< the seam ends where an outline runs on without a corner
    SleeveHead,  ///< the same at the top of a sleeve
    EaseStart,   ///< drawn ease starts or ends
    Balance,     ///< parts of a seam: its middle, quarters or thirds
    ByHand,
};

inline constexpr Word<NotchReason> kNotchReasonWords[] = {{NotchReason::SeamEnd, "seam end"},
                                                          {NotchReason::SleeveHead, "sleeve head"},
                                                          {NotchReason::EaseStart, "ease"},
                                                          {NotchReason::Balance, "balance"},
                                                          {NotchReason::ByHand, "by hand"}};

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

/// Limits of the depth of notches, mm.
inline constexpr double kMinNotchDepth = 1, kMaxNotchDepth = 30;

/// Everything a person has decided about notches.
struct NotchRules {
    bool automatic = true;  ///< false: only those said below
    NotchForm form = NotchForm::Slit;
    double depth = 5;  ///< from the cutting line inwards, mm
    std::vector<NotchSettings> notches{};

    bool operator==(const NotchRules&) const = default;
};

}  // namespace toile
