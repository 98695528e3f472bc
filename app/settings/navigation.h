// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// Whose way of moving the garment view with the mouse a person is used to.
enum class Navigation { Toile, Blender, Clo, Rhino };

}  // namespace toile
