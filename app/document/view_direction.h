// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace toile {

/// From where the garment is looked at, radians: yaw around the upright axis from the front, to the
/// garment's right side as it is seen (+x), pitch upwards.
struct ViewDirection {
    double yaw = 0, pitch = 0;

    bool operator==(const ViewDirection&) const = default;
};

/// Along the axes.
inline constexpr ViewDirection kFrontView{0, 0};
inline constexpr ViewDirection kBackView{std::numbers::pi, 0};
inline constexpr ViewDirection kRightView{std::numbers::pi / 2, 0};
inline constexpr ViewDirection kLeftView{-std::numbers::pi / 2, 0};
inline constexpr ViewDirection kTopView{0, std::numbers::pi / 2};
inline constexpr ViewDirection kBottomView{0, -std::numbers::pi / 2};

}  // namespace toile
