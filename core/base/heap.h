// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// Large blocks that are freed stay with the process, for the next that asks. By itself the C
/// library gives them back to the system, which clears every page before it lends it again: a tenth
/// of the time of factorising half a million triangles over and over, as the window does. The
/// process keeps its greatest size in exchange, and that size is some 5 % more.
/// Call at the start of `main`. Does nothing but with glibc.
void keepFreedMemory();

}  // namespace toile
