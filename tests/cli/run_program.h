// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/core/support/temporary_folder.h"

namespace toile::test {

struct ProgramRun {
    int status = -1;
    std::string out, err;
};

/// Runs a program with arguments, as a shell would, with no display in its environment.
ProgramRun run(const std::string& program, const std::vector<std::string>& arguments);
/// The built program.
ProgramRun toileRun(const std::vector<std::string>& arguments);

/// Files to try it with: a triangle and a square of one piece, `flap`, and a closed surface.
inline constexpr const char* kTriangle = "v 0 0 0\nv 300 0 0\nv 0 400 0\no flap\nf 1 2 3\n";
inline constexpr const char* kPanel =
    "v 0 0 0\nv 300 0 0\nv 300 400 0\nv 0 400 0\no flap\nf 1 2 3\nf 1 3 4\n";
inline constexpr const char* kBall =
    "v 0 0 5\nv 1 0 5\nv 0 1 5\nv 0 0 6\n"
    "o ball\nf -4 -3 -2\nf -4 -1 -3\nf -3 -1 -2\nf -4 -2 -1\n";

}  // namespace toile::test
