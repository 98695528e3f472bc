// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/linalg/front_tree.h"

namespace toile::linalg {

enum class FrontSense {
    Upwards,   ///< a task runs after all its children
    Downwards  ///< a task runs before its children
};

enum class FrontsDone { All, Refused, NoRoom };

/// Runs every task of a tree once, independent ones in parallel; within a `BlasCall`, on as many of
/// the threads as there is memory for.
/// @param work  runs a task. False: it failed, and the others need not run. Its exceptions are
///              rethrown on the calling thread after the others have ended
/// @return NoRoom: there is no memory even for the calling thread
FrontsDone doFronts(const FrontTree& tree, FrontSense sense, int threads,
                    const std::function<bool(int)>& work);

}  // namespace toile::linalg
