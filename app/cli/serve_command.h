// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

namespace toile::app {

/// `toile serve`: answers the requests that it reads, a line each, until "quit" or the end of the
/// input (docs/serve.md). Reads on the calling thread, works on another. @return the exit status
int runServe(std::istream& in, std::ostream& out);

}  // namespace toile::app
