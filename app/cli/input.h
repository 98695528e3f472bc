// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "core/pipeline/pipeline.h"

namespace toile {

struct Arguments;

/// Reads the seams file, if one was given, and the garment. Errors: those of both.
Result<Garment> readInput(const Arguments& arguments, Progress& progress);

/// Every cut that was made: its name, author, length and the piece it opened; nothing where there
/// is none.
void printCuts(const Garment& garment, std::ostream& out);

/// What there is to say about the files and the garment, a sentence a line.
/// @return whether something asked for was not done, which is more than a note
bool printProblems(const Garment& garment, std::ostream& err);

}  // namespace toile
