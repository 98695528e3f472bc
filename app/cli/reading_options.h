// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/arguments.h"

namespace CLI {  // NOLINT(readability-identifier-naming): its own
class App;
}  // namespace CLI

namespace toile::app {

/// How files are read, divided and cut: the commands and the window alike.
void addReading(CLI::App& command, Arguments& arguments);

}  // namespace toile::app
