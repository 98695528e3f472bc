// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::app {

struct Arguments;

/// Runs `toile render`: reads and flattens like `toile flatten`, draws the views without a window
/// and writes a PNG. Prints notes and errors to stderr, one sentence each. Never throws.
/// @return exit status as in the other commands; 3 also if nothing can be drawn here
int runRender(int argc, char** argv, const Arguments& typed);

}  // namespace toile::app
