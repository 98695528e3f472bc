// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): its own
class App;
class Option;
}  // namespace CLI

namespace toile::app {

struct Arguments;

/// Adds whether cloth keeps off itself, and how far. @param needed  asked for with it; may be null
void addSelfContact(CLI::App& command, Arguments& arguments, CLI::Option* needed = nullptr);

/// Adds what `toile prove` is told of pattern, body and cloth to a command.
void addSewing(CLI::App& command, Arguments& arguments);
/// Adds what becomes of a proof. Precondition: the options of sewing are there.
void addProveOutput(CLI::App& command, Arguments& arguments);

}  // namespace toile::app
