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

// The commands that need no display, and their shared functions.

/// Runs `toile` with a command, `--help` or `--version` as parsed. Output goes to stdout,
/// errors to stderr, one sentence each. Never throws.
int runCommand(const Answer<Arguments>& typed);

/// One function per command; each returns the exit status.
int runCheck(const Arguments& arguments, std::ostream& out, Messages& messages);
int runFlatten(const Arguments& arguments, std::ostream& out, Messages& messages);
/// Processes each garment of a list in its own process.
int runBatch(const Arguments& arguments, std::ostream& out, Messages& messages);
int runCompare(const Arguments& arguments, std::ostream& out, Messages& messages);
int runInfo(const Arguments& arguments, std::ostream& out, Messages& messages);
int runWalk(const Arguments& arguments, std::ostream& out, Messages& messages);
int runMarker(const Arguments& arguments, std::ostream& out, Messages& messages);
int runProve(const Arguments& arguments, std::ostream& out, Messages& messages);
/// Answers requests, one per line, until "quit" or the end of the input (docs/serve.md). Reads on
/// the calling thread, works on another.
int runServe(std::istream& in, std::ostream& out);

// Reading

/// Whether a file is a mesh or a project, judged by its extension.
bool looksLikeGarment(const std::filesystem::path& path);

/// Why a project cannot be used with the typed inputs, for the commands and the window.
std::optional<Refusal> refusalOfProject(const Arguments& arguments);
/// If the input is a project file, returns the arguments with its meshes as inputs and its
/// settings, overridden by typed options. Otherwise returns them unchanged.
Answer<Arguments> withProject(Arguments arguments, Messages& messages);

/// Settings for making the garment, including the seams file if there is one.
Answer<LoadOptions> loadingOf(const Arguments& arguments, Messages& messages);
/// Reads the garment and the seams file, if there is one. Reports differences from the garment that
/// a project was made with. Pieces get their names from the project.
Answer<Garment> readGarment(const Arguments& arguments, Progress& progress, Messages& messages);
/// The same; reports a refusal and returns nullopt.
std::optional<Garment> readInput(const Arguments& arguments, Progress& progress,
                                 Messages& messages);
/// Reports differences from the garment that the project was made with.
void reportDifferences(const Arguments& arguments, const Garment& garment, Messages& messages);

// Flattening and writing

/// The pattern that arguments and project ask for.
PatternOrder orderOf(const Arguments& arguments, const Garment& garment);
/// The flattened pieces, without those excluded by a project.
PieceResults flattened(const Arguments& arguments, const Garment& garment, Progress& progress);
PieceResults withoutLeftOut(const Arguments& arguments, const Garment& garment,
                            PieceResults results);
/// The pattern of `orderOf`.
FinishedPattern finished(const Arguments& arguments, const Garment& garment,
                         const PieceResults& results);

/// Explains that no piece is flat, so that there is no pattern to write or sew; nullopt if one is.
std::optional<Refusal> refusalOfNoPattern(const PieceResults& results);
/// The same for these files: a report can be written even if no piece is flat.
std::optional<Refusal> refusalOfNoPattern(const PieceResults& results,
                                          const std::vector<std::filesystem::path>& outputs);
/// Exports a pattern; prints each file with the result of reading it back, and reports failures.
/// @return whether all are written
bool writePatterns(const std::vector<std::filesystem::path>& outputs, const ExportSource& source,
                   std::ostream& out, Messages& messages);

// Proving

/// The proof settings, with the body read; the sewn pattern is the garment's own. Refused: as
/// `readBody`, and kNotProved if the body does not suit the garment.
Answer<ProofOrder> orderOfOwn(const Arguments& arguments, const Garment& garment,
                              Progress& progress);
/// The same, also reading the pattern to sew. Refused: also as `readPatternFile`.
Answer<ProofOrder> proofOrder(const Arguments& arguments, const Garment& garment,
                              Progress& progress);
/// Notes from reading the pattern file; empty without one.
std::vector<std::string> notesOf(const ProofOrder& order);
/// Why a pattern was not sewn. If nothing is flat, says that instead of the error.
Refusal refusalOfProof(const Error& error, const PieceResults& results);

/// Draws a PNG file of a proof; empty if drawing is not possible.
using DrawProof = std::string (*)(const ExportSource& source,
                                  const std::shared_ptr<const Proof>& proof,
                                  const Arguments& arguments);
/// Programs that can draw call this before running the command.
void provideProofPictures(DrawProof draw);
/// Null if this program cannot draw.
DrawProof proofPictures();

// Printing

/// Prints all cuts with name, author, length and piece; nothing if there is none.
void printCuts(const Garment& garment, std::ostream& out);
void printTable(const ReportTable& table, std::ostream& out);
/// @return whether a request was not fulfilled, beyond mere notes
bool reportProblems(const Garment& garment, Messages& messages);
/// Reports failed pieces, and notes of the others.
/// @return whether a piece failed, crosses itself or breaks a guarantee of its method
bool reportFailures(const PieceResults& results, Messages& messages);
/// Reports omissions and assumptions made while reading a pattern.
void reportPatternNotes(const std::filesystem::path& path, const PatternFile& file,
                        Messages& messages);

/// A plain text table: first column left-aligned, the others right-aligned. Cells are passed
/// through `shownText`.
class Table {
public:
    explicit Table(std::vector<std::string> head) { rows_.push_back(std::move(head)); }
    void add(std::vector<std::string> row);
    void print(std::ostream& out) const;

private:
    std::vector<std::vector<std::string>> rows_;
};

/// While one exists, Ctrl-C cancels the work instead of ending the program. One at a time.
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
