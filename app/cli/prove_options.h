// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): its own
class App;
class Option;
}  // namespace CLI

namespace toile::app {

struct Arguments;

/// Adds the file of a pattern that stands in the garment's own place: where another can, it
/// excludes this. @param what  becomes of it @param otherwise  what holds where it is left out
CLI::Option* addPatternFile(CLI::App& command, Arguments& arguments, const std::string& what,
                            const std::string& otherwise = {});

/// Adds whether cloth keeps off itself, and how far. @param needed  asked for with it; may be null
void addSelfContact(CLI::App& command, Arguments& arguments, CLI::Option* needed = nullptr);

/// Adds what `toile prove` is told of pattern, body and cloth to a command.
void addSewing(CLI::App& command, Arguments& arguments);
/// Adds what becomes of a proof. Precondition: the options of sewing are there.
void addProveOutput(CLI::App& command, Arguments& arguments);

}  // namespace toile::app
