// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <optional>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/exit_status.h"
#include "core/garment/garment.h"
#include "core/toile/toile.h"

namespace toile::app {

// The commands that need no display.

struct Arguments;

/// Runs `toile` with a command, `--help` or `--version` as parsed. Output goes to stdout,
/// errors to stderr, one sentence each. Never throws.
int runCommand(const Arguments& typed);

/// One function per command; each returns the exit status.
int runCheck(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runFlatten(const Arguments& arguments, std::ostream& out, std::ostream& err);
/// Each garment of a list in a process of its own.
int runBatch(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runCompare(const Arguments& arguments, std::ostream& out, std::ostream& err);
/// With `--pattern`: compares with a pattern from a file.
int runComparePattern(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runInfo(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runWalk(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runMarker(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runProve(const Arguments& arguments, std::ostream& out, std::ostream& err);
/// Of an instance of the nesting problem.
int runMarkerOfInstance(const Arguments& arguments, std::ostream& out, std::ostream& err);

/// Where the input is a project file: the same arguments with its meshes as the input and with what
/// it says of reading and, as far as nothing else was typed, of flattening. Anything else comes
/// back as it is. What cannot be done comes back as a Message; notes are printed.
Arguments withProject(Arguments arguments, std::ostream& err);

/// The pattern that the arguments and their project ask for.
PatternOrder orderOf(const Arguments& arguments, const Garment& garment);
/// The same, made.
FinishedPattern finished(const Arguments& arguments, const Garment& garment,
                         const PieceResults& results);

/// Why a project among the inputs cannot be taken as it was typed, for the commands and the window:
/// a Message; none where it can, or where there is no project.
std::optional<Arguments> refusalOfProject(const Arguments& arguments);

/// Prints how the garment is not the one the project was made with; nothing without a project.
void printDifferences(const Arguments& arguments, const Garment& garment, std::ostream& err);

}  // namespace toile::app
