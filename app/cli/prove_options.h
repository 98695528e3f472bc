// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}  // namespace CLI

namespace toile::app {

struct Arguments;

/// Adds what `toile prove` is told of pattern, body and cloth to a command.
void addProveOptions(CLI::App& command, Arguments& arguments);

}  // namespace toile::app
