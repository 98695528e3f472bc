// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/progress.h"
#include "core/formats/export_source.h"
#include "core/formats/pattern_file.h"
#include "core/formats/tables/report_tables.h"
#include "core/garment/garment.h"
#include "core/prove/proof.h"
#include "core/toile/pipeline.h"
#include "core/toile/toile.h"

namespace toile::app {

// The commands that need no display, and what they share.

/// Runs `toile` with a command, `--help` or `--version` as parsed. Output goes to stdout,
/// errors to stderr, one sentence each. Never throws.
int runCommand(const Answer<Arguments>& typed);

/// One function per command; each returns the exit status.
int runCheck(const Arguments& arguments, std::ostream& out, Messages& messages);
int runFlatten(const Arguments& arguments, std::ostream& out, Messages& messages);
/// Each garment of a list in a process of its own.
int runBatch(const Arguments& arguments, std::ostream& out, Messages& messages);
int runCompare(const Arguments& arguments, std::ostream& out, Messages& messages);
int runInfo(const Arguments& arguments, std::ostream& out, Messages& messages);
int runWalk(const Arguments& arguments, std::ostream& out, Messages& messages);
int runMarker(const Arguments& arguments, std::ostream& out, Messages& messages);
int runProve(const Arguments& arguments, std::ostream& out, Messages& messages);
/// Answers the requests that it reads, a line each, until "quit" or the end of the input
/// (docs/serve.md). Reads on the calling thread, works on another.
int runServe(std::istream& in, std::ostream& out);

// Reading

/// Whether a file is a mesh or a project, by its ending alone.
bool looksLikeGarment(const std::filesystem::path& path);

/// Why a project among the inputs cannot be used as it was typed, for the commands and the window.
std::optional<Refusal> refusalOfProject(const Arguments& arguments);
/// If the input is a project file: with its meshes as inputs and with its settings, on top of which
/// typed options hold. Anything else comes back unchanged.
Answer<Arguments> withProject(Arguments arguments, Messages& messages);

/// How the garment is to be made, with the seams file read, if there is one.
Answer<LoadOptions> loadingOf(const Arguments& arguments, Messages& messages);
/// Reads the seams file, if there is one, and the garment. Reports differences to the garment that
/// a project was made with. Pieces have the names that the project gives them.
Answer<Garment> readGarment(const Arguments& arguments, Progress& progress, Messages& messages);
/// The same; empty if it is refused, which is reported.
std::optional<Garment> readInput(const Arguments& arguments, Progress& progress,
                                 Messages& messages);
/// Reports differences to the garment that the project was made with.
void reportDifferences(const Arguments& arguments, const Garment& garment, Messages& messages);

// Flattening and writing

/// The pattern that the arguments and their project ask for.
PatternOrder orderOf(const Arguments& arguments, const Garment& garment);
/// The pieces, flat; without those that a project leaves out.
PieceResults flattened(const Arguments& arguments, const Garment& garment, Progress& progress);
PieceResults withoutLeftOut(const Arguments& arguments, const Garment& garment,
                            PieceResults results);
/// The pattern of `orderOf`.
FinishedPattern finished(const Arguments& arguments, const Garment& garment,
                         const PieceResults& results);

/// Why there is no pattern to write or sew: no piece lies flat. Nothing if one does.
std::optional<Refusal> refusalOfNoPattern(const PieceResults& results);
/// The same for these files: a report is written also if no piece lies flat.
std::optional<Refusal> refusalOfNoPattern(const PieceResults& results,
                                          const std::vector<std::filesystem::path>& outputs);
/// Exports a pattern to files; prints each with what reading it back found, and reports what
/// fails. @return whether all are written
bool writePatterns(const std::vector<std::filesystem::path>& outputs, const ExportSource& source,
                   std::ostream& out, Messages& messages);

// Proving

/// What holds the cloth, with the body read; the sewn pattern is the garment's own. Refused: as
/// `readBody`, and kNotProved if the body does not suit the garment.
Answer<ProofOrder> orderOfOwn(const Arguments& arguments, const Garment& garment,
                              Progress& progress);
/// The same with the pattern to sew, read too. Refused: also as `readPatternFile`.
Answer<ProofOrder> proofOrder(const Arguments& arguments, const Garment& garment,
                              Progress& progress);
/// Notes of reading the pattern file; empty without one.
std::vector<std::string> notesOf(const ProofOrder& order);
/// Why a pattern was not sewn: if nothing is flat, that explains more than the error.
Refusal refusalOfProof(const Error& error, const PieceResults& results);

/// Draws a PNG file of a proof; empty if nothing can be drawn here.
using DrawProof = std::string (*)(const ExportSource& source,
                                  const std::shared_ptr<const Proof>& proof,
                                  const Arguments& arguments);
/// Called by programs that can draw, before the command runs.
void provideProofPictures(DrawProof draw);
/// Null if this program cannot draw.
DrawProof proofPictures();

// Printing

/// All cuts with name, author, length and piece; nothing if there is none.
void printCuts(const Garment& garment, std::ostream& out);
void printTable(const ReportTable& table, std::ostream& out);
/// @return whether something that was asked for was not done, which is more than a note
bool reportProblems(const Garment& garment, Messages& messages);
/// Reports failed pieces and notes of the others.
/// @return whether a piece failed, crosses itself or breaks its method's promise
bool reportFailures(const PieceResults& results, Messages& messages);
/// Reports what was left out or guessed when a pattern was read.
void reportPatternNotes(const std::filesystem::path& path, const PatternFile& file,
                        Messages& messages);

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

/// While one exists, Ctrl-C cancels the work and does not end the program. One at a time.
class Interruptible {
public:
    explicit Interruptible(Progress& progress) {
        current = &progress;
        before_ = std::signal(SIGINT, [](int) { current->cancel(); });
    }
    ~Interruptible() { std::signal(SIGINT, before_); }
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

private:
    static inline Progress* current = nullptr;  // reachable from the signal handler
    void (*before_)(int);
};

}  // namespace toile::app
