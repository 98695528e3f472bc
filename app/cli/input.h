// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/cli/refusal.h"
#include "core/formats/pattern_file.h"
#include "core/formats/tables/report_tables.h"
#include "core/toile/pipeline.h"

namespace toile::app {

struct Arguments;

/// Whether it is a mesh or a project, by its ending alone: it need not be there.
bool looksLikeGarment(const std::filesystem::path& path);

/// How the garment is to be made, with the seams file read, if one was given; notes are printed.
/// Errors: those of `readSeamsFile`.
Result<LoadOptions> loadingOf(const Arguments& arguments, std::ostream& err);

/// Reads the seams file, if one was given, and the garment. Prints why one cannot be read, then
/// there is no garment; and how the garment is not the one that a project was made with. Pieces
/// have the names that the project gives them.
std::optional<Garment> readInput(const Arguments& arguments, Progress& progress, std::ostream& err);

/// The same with the reason as a value; notes are printed.
Result<Garment> readGarment(const Arguments& arguments, Progress& progress, std::ostream& err);

/// Flattens the garment as the arguments ask; what a project leaves out is not flat.
PieceResults flattened(const Arguments& arguments, const Garment& garment, Progress& progress);
/// The results but those of pieces that a project leaves out.
PieceResults withoutLeftOut(const Arguments& arguments, const Garment& garment,
                            PieceResults results);

/// Every cut that was made: its name, author, length and the piece it opened; nothing where there
/// is none.
void printCuts(const Garment& garment, std::ostream& out);

/// Prints why it cannot be done. @return the exit status, kExitUnreadable
int refuse(const Refusal& refusal, std::ostream& err);

/// What there is to say about the files and the garment, a sentence a line.
/// @return whether something asked for was not done, which is more than a note
bool printProblems(const Garment& garment, std::ostream& err);

void printTable(const ReportTable& table, std::ostream& out);

/// Why pieces could not be flattened, and what there is to say of those that were, a sentence a
/// line.
/// @return whether any could not, or is flipped although its method promises that none does
bool printFailures(const PieceResults& results, std::ostream& err);

/// What was left out or guessed when a pattern was read, a sentence a line.
void printPatternNotes(const std::filesystem::path& path, const PatternFile& file,
                       std::ostream& err);

/// A plain text table: first column flush left, the others flush right. Cells are shown as
/// `shownText`.
class Table {
public:
    explicit Table(std::vector<std::string> head) { rows_.push_back(std::move(head)); }
    void add(std::vector<std::string> row);
    void print(std::ostream& out) const;

private:
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace toile::app
