// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/exit_status.h"

namespace toile::app {
namespace {

constexpr ExitMeaning kExitMeanings[] = {
    {"0", "fine, or doubts only"},
    {"1",
     "cloth would be cut wrong, and all files are written: a piece failed or has no usable cut, "
     "its outline crosses itself, triangles are flipped, or, where no fabric is chosen, its mean "
     "strain is above 6 % or 5 % of its area is strained by more than 25 %; check or prove found "
     "faults, walk unequal lengths, compare a piece without a partner, marker a piece without "
     "room; or with --fail-on doubt there is a doubt"},
    {"2", "wrong usage"},
    {"3", "a file cannot be read or written, memory did not suffice, or the window has no display"},
    {"128 + N", "batch was ended by signal N: 130 after Ctrl-C, 143 after SIGTERM"},
};

}  // namespace

std::span<const ExitMeaning> exitMeanings() {
    return kExitMeanings;
}

}  // namespace toile::app
