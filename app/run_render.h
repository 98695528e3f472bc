// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::app {

struct Arguments;

/// Runs `toile render`: reads and flattens as `toile flatten` does, draws the views without a
/// window and writes them as PNG. Notes and errors go to stderr, a sentence each. Never throws.
/// @return exit status as of the other commands; 3 also where nothing can be drawn here
int runRender(int argc, char** argv, const Arguments& typed);

}  // namespace toile::app
