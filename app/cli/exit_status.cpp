// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/exit_status.h"

namespace toile::app {
namespace {

constexpr ExitMeaning kExitMeanings[] = {
    {"0", "all pieces are done, and what was asked about is as it should be"},
    {"1",
     "some piece or garment failed, or isometric flipped triangles (the rest is written); check or "
     "prove found faults, walk unequal lengths, compare a piece without a partner, marker a piece "
     "without room; or with --fail-on doubt the pattern is in doubt"},
    {"2", "wrong usage"},
    {"3", "a file cannot be read or written, memory did not suffice, or the window has no display"},
    {"128 + N", "batch was ended by signal N: 130 after Ctrl-C, 143 after SIGTERM"},
};

}  // namespace

std::span<const ExitMeaning> exitMeanings() {
    return kExitMeanings;
}

}  // namespace toile::app
