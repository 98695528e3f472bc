// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/linalg/front_tree.h"

namespace toile::linalg {

enum class FrontSense {
    Upwards,   ///< a task after all that wait for it
    Downwards  ///< and before
};

enum class FrontsDone { All, Refused, NoRoom };

/// Does all tasks of a tree, each once, those that do not wait for each other side by side; within
/// a `BlasCall`, by as many of the threads as there is room for.
/// @param work  does a task. False: it cannot be done, and nothing else need be. What it throws is
///              thrown on the calling thread, when the others have ended
/// @return NoRoom: the calling thread itself has none
FrontsDone doFronts(const FrontTree& tree, FrontSense sense, int threads,
                    const std::function<bool(int)>& work);

}  // namespace toile::linalg
