// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

namespace toile {

struct Arguments;

/// One function per command; each returns the exit status.
int runCheck(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runFlatten(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runCompare(const Arguments& arguments, std::ostream& out, std::ostream& err);
int runInfo(const Arguments& arguments, std::ostream& out, std::ostream& err);

}  // namespace toile
