// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/cut/auto_cut.h"

namespace toile::test {

/// The proposal; a failed expectation and nothing where there is none.
AutoCut propose(const MeshArrays& mesh, const AutoCutOptions& options = {});

/// Proposes and cuts; expects a valid cut and one disk.
AutoCut expectOneDisk(const MeshArrays& mesh, const std::string& what,
                      const AutoCutOptions& options = {});

}  // namespace toile::test
