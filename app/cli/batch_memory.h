// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::app {

/// From here on this process may take so much memory beside what it has, what its threads' stacks
/// may grow to and the working memory of the BLAS, most of which is never touched: what goes beyond
/// is refused by the system. Where that cannot be, it may take all there is.
/// @param mib  > 0  @param threads  that work at a time
void limitMemory(int mib, int threads);

/// Its memory has no bound from here on.
void liftMemoryLimit();

}  // namespace toile::app
