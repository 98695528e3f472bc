// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace toile {

/// What the mouse does, for the help page; keys are in the table of actions.
struct Gesture {
    const char* group;  ///< to be translated, as the others
    const char* keys;
    const char* does;
};

/// Those of one group follow each other.
const std::vector<Gesture>& gestures();

}  // namespace toile
