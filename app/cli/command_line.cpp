// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <utility>

#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/formats/drawing/drawing.h"
#include "core/formats/export_file.h"
#include "core/formats/formats.h"
#include "core/io/soup.h"
#include "core/linalg/blas_call.h"
#include "core/project/piece_names.h"
#include "core/project/piece_settings.h"
#include "core/project/project_file.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

int run(const Answer<Arguments>& typed, std::ostream& out, Messages& messages) {
    const auto checked = typed ? withProject(*typed, messages) : typed;
    if (!checked) {
        return refuse(checked.refusal(), messages);
    }
    const Arguments& arguments = *checked;
    const char* missing = "has no window";
    switch (arguments.command) {
        case Arguments::Command::Flatten:
            return runFlatten(arguments, out, messages);
        case Arguments::Command::Batch:
            linalg::useOneBlasThread();  // before forking, or each child would start threads
            return runBatch(arguments, out, messages);
        case Arguments::Command::Compare:
            return runCompare(arguments, out, messages);
        case Arguments::Command::Check:
            return runCheck(arguments, out, messages);
        case Arguments::Command::Info:
            return runInfo(arguments, out, messages);
        case Arguments::Command::Walk:
            return runWalk(arguments, out, messages);
        case Arguments::Command::Marker:
            return runMarker(arguments, out, messages);
        case Arguments::Command::Prove:
            return runProve(arguments, out, messages);
        case Arguments::Command::Serve:
            return runServe(std::cin, out);
        case Arguments::Command::Message:
            out << arguments.message;
            return kExitDone;
        case Arguments::Command::Render:
            missing = "cannot draw pictures";
            break;
        case Arguments::Command::Window:
            break;
    }
    messages.add(std::string("this build ") + missing + "; see toile --help.");
    return kExitUsage;
}

}  // namespace

int runCommand(const Answer<Arguments>& typed) {
    Messages messages(std::cerr);
    try {
        const int status = run(typed, std::cout, messages);
        if (std::cout.flush()) {
            return status;
        }
        messages.add("standard output cannot be written (a full disk or a closed pipe).");
        return kExitUnreadable;
    } catch (const std::exception& fault) {  // out of memory, or a bug: still one sentence
        messages.add(std::string("stopped by an unexpected error (") + fault.what() + ").");
        return kExitUnreadable;
    }
}

bool looksLikeGarment(const fs::path& path) {
    const std::string ending = path.extension().string();
    return isProjectFile(path) || std::ranges::any_of(readableEndings(), [&](const auto& known) {
               return equalsIgnoringCase(ending, known);
           });
}

std::optional<Refusal> refusalOfProject(const Arguments& arguments) {
    const auto project = std::ranges::find_if(arguments.inputs, isProjectFile);
    if (project == arguments.inputs.end()) {
        return std::nullopt;
    }
    if (arguments.inputs.size() > 1) {
        return usageRefusal("a project must be the only input: \"" + project->string() + "\".");
    }
    if (isAnyTyped(arguments, kReading)) {
        return usageRefusal(
            "a project sets how its files are read and cut; leave out those options, or open its "
            "meshes instead.");
    }
    if (arguments.command == Arguments::Command::Window && isAnyTyped(arguments, kFlattening)) {
        return usageRefusal(
            "a project sets how its pieces are flattened; leave out those options, and change them "
            "in the window.");
    }
    return std::nullopt;
}

Answer<Arguments> withProject(Arguments arguments, Messages& messages) {
    const auto path = std::ranges::find_if(arguments.inputs, isProjectFile);
    if (path == arguments.inputs.end()) {
        return arguments;
    }
    if (auto refusal = refusalOfProject(arguments)) {
        return *std::move(refusal);
    }
    auto read = readProject(*path);
    if (!read) {
        return read.error();
    }
    for (const Error& note : read->notes) {
        messages.add(note);
    }
    Project& project = read->project;
    const auto missing = locateMeshes(project);
    if (!missing.empty()) {
        return Error{ErrorCode::FileUnreadable, Subject::file(missing.front().string()),
                     "the project needs this file, which does not exist"};
    }
    arguments.inputs.clear();
    for (const FileReference& file : project.files) {
        arguments.inputs.push_back(file.path);
    }
    std::vector<fs::path> meshes = arguments.inputs;
    meshes.push_back(project.proof.body);
    for (const fs::path& output : arguments.outputs) {
        for (const fs::path& mesh : meshes) {
            std::error_code ignored;
            if (fs::equivalent(mesh, output, ignored)) {
                return usageRefusal("\"" + output.string() +
                                    "\" is a mesh of the project and would be overwritten.");
            }
        }
    }
    arguments = withSettingsOf(project, std::move(arguments));
    arguments.load = project.loading;
    if (!arguments.fabric) {
        arguments.fabric = project.fabric;
    }
    arguments.project = std::move(project);
    return arguments;
}

Answer<LoadOptions> loadingOf(const Arguments& arguments, Messages& messages) {
    LoadOptions options = arguments.load;
    if (!arguments.seams.empty()) {
        Problems notes;
        auto seams = readSeamsFile(arguments.seams, &notes);
        if (!seams) {
            return seams.error();
        }
        for (const Error& note : notes) {
            messages.add(note);
        }
        options.seams = std::move(*seams);
    }
    return options;
}

Answer<Garment> readGarment(const Arguments& arguments, Progress& progress, Messages& messages) {
    const auto loading = loadingOf(arguments, messages);
    if (!loading) {
        return loading.refusal();
    }
    auto garment = loadGarment(arguments.inputs, *loading, progress);
    if (!garment) {
        return garment.error();
    }
    reportDifferences(arguments, *garment, messages);
    return arguments.project ? named(std::move(*garment), arguments.project->labels)
                             : std::move(*garment);
}

std::optional<Garment> readInput(const Arguments& arguments, Progress& progress,
                                 Messages& messages) {
    auto garment = readGarment(arguments, progress, messages);
    if (!garment) {
        refuse(garment.refusal(), messages);
        return std::nullopt;
    }
    return *std::move(garment);
}

void reportDifferences(const Arguments& arguments, const Garment& garment, Messages& messages) {
    if (arguments.project) {
        for (const Error& difference : differencesTo(*arguments.project, garment)) {
            messages.add(difference);
        }
    }
}

PatternOrder orderOf(const Arguments& arguments, const Garment& garment) {
    PatternOrder order{.flattening = arguments.options,
                       .lines = arguments.lines,
                       .fabric = arguments.fabric.value_or(fabricPresets().front()),
                       .byHalf = arguments.byHalf,
                       .threads = arguments.threads};
    if (arguments.project) {
        order.materials = arguments.project->materials;
        order.pieces = settingsFor(*arguments.project, garment);
    }
    return order;
}

PieceResults flattened(const Arguments& arguments, const Garment& garment, Progress& progress) {
    return withoutLeftOut(arguments, garment,
                          flatten(garment, orderOf(arguments, garment), progress));
}

PieceResults withoutLeftOut(const Arguments& arguments, const Garment& garment,
                            PieceResults results) {
    return arguments.project ? toile::withoutLeftOut(std::move(results), garment,
                                                     settingsFor(*arguments.project, garment))
                             : std::move(results);
}

FinishedPattern finished(const Arguments& arguments, const Garment& garment,
                         const PieceResults& results) {
    return makePattern(garment, results, orderOf(arguments, garment));
}

std::optional<Refusal> refusalOfNoPattern(const PieceResults& results) {
    const auto isFlat = [](const auto& result) -> bool { return result->flat.has_value(); };
    if (std::ranges::any_of(results, isFlat)) {
        return std::nullopt;
    }
    return Refusal(kNotFlat, "no piece could be flattened, so there is no pattern.");
}

std::optional<Refusal> refusalOfNoPattern(const PieceResults& results,
                                          const std::vector<fs::path>& outputs) {
    const auto isReport = [](const fs::path& output) {
        const Format* format = formatOf(output);
        return format != nullptr && (format->id == FormatId::Report ||
                                     format->id == FormatId::Html || format->id == FormatId::Csv);
    };
    return std::ranges::all_of(outputs, isReport) ? std::nullopt : refusalOfNoPattern(results);
}

bool writePatterns(const std::vector<fs::path>& outputs, const ExportSource& source,
                   std::ostream& out, Messages& messages) {
    if (outputs.empty()) {
        return true;
    }
    if (refusalOfNoPattern(source.results())) {
        messages.add("no piece could be flattened, so the written files contain no pattern");
    }
    for (const Wording& note : overlapNotes(source.laid().pattern, source.drawing())) {
        messages.add(note);
    }
    bool isDone = true;
    for (const auto& output : outputs) {
        const auto written = exportFile(output, source);
        if (!written) {
            messages.add(written.error());
            isDone = false;
            continue;
        }
        for (const Wording& note : written->notes) {
            messages.add(output.string() + ": " + std::string(note));
        }
        for (const fs::path& file : written->files) {
            out << "wrote " << file.string();
            if (written->readBack && file == written->files.front()) {
                out << "; " << readBackSentence(*written->readBack);
            }
            out << '\n';
        }
    }
    return isDone;
}

void printCuts(const Garment& garment, std::ostream& out) {
    if (garment.cuts.empty()) {
        return;
    }
    const bool hasEvidence = std::ranges::any_of(
        garment.cuts, [](const AppliedCut& cut) { return !cut.evidence.empty(); });
    std::vector<std::string> heads{"cut", "made by", "of", "length mm"};
    if (hasEvidence) {
        heads.emplace_back("because");
    }
    Table table(heads);
    for (const AppliedCut& cut : garment.cuts) {
        std::vector<std::string> row{cut.name, cut.author == CutAuthor::User ? "user" : "Toile",
                                     cut.piece, fixed(cut.length, 1)};
        if (hasEvidence) {
            row.push_back(cut.evidence);
        }
        table.add(row);
    }
    table.print(out);
    out << '\n';
}

void printTable(const ReportTable& table, std::ostream& out) {
    Table printed(table.head);
    for (const auto& row : table.rows) {
        printed.add(row);
    }
    printed.print(out);
}

bool reportProblems(const Garment& garment, Messages& messages) {
    bool failed = false;
    for (const auto& file : garment.files) {
        for (const Error& problem : file->problems) {
            messages.add(problem);
        }
    }
    for (const Error& problem : garment.problems) {
        messages.add(problem);
        failed = failed || !isNote(problem.code);
    }
    return failed;
}

bool reportFailures(const PieceResults& results, Messages& messages) {
    bool failed = false;
    for (const auto& result : results) {
        if (result->error && !isLeftOut(*result)) {
            messages.add(*result->error);
            failed = true;
        }
        failed = failed || breaksPromise(*result) || crossesItself(*result);
        if (result->flat) {
            for (const Error& note : result->flat->notes) {
                messages.add(note);
            }
        }
    }
    return failed;
}

void reportPatternNotes(const fs::path& path, const PatternFile& file, Messages& messages) {
    for (const Wording& note : file.notes) {
        messages.add(shownText(path.string(), kMaxOfPlace) + ": " + shownText(note, kMaxOfDetail));
    }
}

void Table::add(std::vector<std::string> row) {
    for (std::string& cell : row) {
        cell = shownText(cell);
    }
    rows_.push_back(std::move(row));
}

void Table::print(std::ostream& out) const {
    std::vector<std::size_t> widths;
    for (const auto& row : rows_) {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t c = 0; c < row.size(); ++c) {
            widths[c] = std::max(widths[c], characterCount(row[c]));
        }
    }
    for (const auto& row : rows_) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string gap(widths[c] - characterCount(row[c]), ' ');
            line += c == 0 ? row[c] + gap : "  " + gap + row[c];
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out << line << '\n';
    }
}

}  // namespace toile::app
