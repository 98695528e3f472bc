// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::bench {

/// Adds to the run what it is measured on and with: processor, cores, memory, compiler, libraries.
/// Nothing that names the machine or its owner.
void describeMachine();

}  // namespace toile::bench
