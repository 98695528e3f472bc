// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// Large blocks that are freed stay with the process, for the next that asks. By itself the C
/// library gives them back to the system, which clears every page before it lends it again: a tenth
/// of the time of factorising half a million triangles over and over, as the window does. The
/// process keeps its greatest size in exchange, and that size is some 5 % more. All threads share
/// one heap, so that what one has freed another can take. Call at the start of `main`. Does nothing
/// but with glibc.
void keepFreedMemory();

/// Gives freed memory back to the system, from between what is in use as well: before something
/// large is made, so that the two do not add up. Does nothing after `keepFreedMemory`, and but with
/// glibc. Thread-safe. Cost: milliseconds for a hundred megabytes.
void returnFreedMemory();

}  // namespace toile
