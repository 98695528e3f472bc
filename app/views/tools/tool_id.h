// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// What the left mouse button does in the views.
enum class ToolId { Select, Cut, Loop, Dart, Join, Measure, Grain };

inline constexpr int kToolCount = 7;

}  // namespace toile
