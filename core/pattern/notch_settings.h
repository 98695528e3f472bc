// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/words.h"
#include "core/garment/seam.h"

namespace toile {

/// The shape of a notch (notch_mark.h).
enum class NotchForm { Slit, V, T, Castle };

/// Their names in project files.
inline constexpr Word<NotchForm> kNotchFormWords[] = {{NotchForm::Slit, "slit"},
                                                      {NotchForm::V, "v"},
                                                      {NotchForm::T, "t"},
                                                      {NotchForm::Castle, "castle"}};

/// Why a notch is where it is.
enum class NotchReason {
    SeamEnd,     ///< the seam ends where an outline runs on without a corner
    SleeveHead,  ///< the same at the top of a sleeve
    EaseStart,   ///< drawn ease starts or ends
    Balance,     ///< divides a seam: its middle, quarters or thirds
    ByHand,
};

inline constexpr Word<NotchReason> kNotchReasonWords[] = {{NotchReason::SeamEnd, "seam end"},
                                                          {NotchReason::SleeveHead, "sleeve head"},
                                                          {NotchReason::EaseStart, "ease"},
                                                          {NotchReason::Balance, "balance"},
                                                          {NotchReason::ByHand, "by hand"}};

/// A notch that the user added or removed: a place on either line of a seam, as a share of it, so
/// that it stays wherever the seam is cut. Dragging a notch removes and adds one.
struct NotchSettings {
    LineId line;
    double at = 0;
    bool reversed = false;       ///< on the side of the line that runs against it
    bool isThere = true;         ///< false: the notch nearest to the place is removed
    std::optional<int> count{};  ///< 1 or 2; empty: by convention (Notch::count)

    bool operator==(const NotchSettings&) const = default;
};

/// Limits of the depth of notches, mm.
inline constexpr double kMinNotchDepth = 1, kMaxNotchDepth = 30;

/// All settings of notches.
struct NotchRules {
    bool automatic = true;  ///< false: only `notches`
    NotchForm form = NotchForm::Slit;
    double depth = 5;  ///< from the cutting line inwards, mm
    std::vector<NotchSettings> notches{};

    bool operator==(const NotchRules&) const = default;
};

}  // namespace toile
