// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

namespace toile::app {

/// The commands that need no display. Exit status: 0 all pieces done, 1 some piece failed (the rest
/// is written) or a check found faults, 2 wrong usage, 3 input unreadable or output unwritable.
enum ExitStatus { kExitDone = 0, kExitSomeFailed = 1, kExitUsage = 2, kExitUnreadable = 3 };

struct Arguments;

/// Runs `toile flatten`, `toile compare`, `toile check`, `toile info`, `--help` or `--version` as
/// parsed. Output goes to stdout, errors to stderr, one sentence each. Never throws.
int runCommand(const Arguments& typed);

/// One function per command; each returns the exit status.
int runCheck(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runFlatten(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runCompare(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runInfo(const Arguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace toile::app
