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

}  // namespace toile::test
