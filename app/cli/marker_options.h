// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/marker_arguments.h"

namespace CLI {  // NOLINT(readability-identifier-naming): its own
class App;
}  // namespace CLI

namespace toile::app {

/// Adds what `toile marker` is told of cloth and search to a command.
void addMarkerOptions(CLI::App& command, MarkerArguments& marker);

}  // namespace toile::app
