// SPDX-License-Identifier: GPL-3.0-or-later
// The target that is no reader of the core's, in a program of its own: it needs the command line.
#include <array>

#include "tests/fuzz/check_serve.h"
#include "tests/fuzz/targets.h"

namespace toile::fuzz {

std::span<const Target> targets() {
    static constexpr std::array<Target, 1> kServeTarget = {{{"serve", whatBreaksInServe}}};
    return kServeTarget;
}

}  // namespace toile::fuzz
