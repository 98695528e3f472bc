// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input.h"

#include <algorithm>
#include <ostream>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/io/soup.h"
#include "core/project/piece_names.h"
#include "core/project/piece_settings.h"
#include "core/project/project_file.h"

namespace toile::app {

bool looksLikeGarment(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    return isProjectFile(path) || std::ranges::any_of(readableEndings(), [&](const auto& known) {
               return equalsIgnoringCase(ending, known);
           });
}

Result<LoadOptions> loadingOf(const Arguments& arguments, std::ostream& err) {
    LoadOptions options = arguments.load;
    if (!arguments.seams.empty()) {
        Problems notes;
        auto seams = readSeamsFile(arguments.seams, &notes);
        if (!seams) {
            return seams.error();
        }
        for (const Error& note : notes) {
            err << "toile: " << sentence(note) << '\n';
        }
        options.seams = std::move(*seams);
    }
    return options;
}

std::optional<Garment> readInput(const Arguments& arguments, Progress& progress,
                                 std::ostream& err) {
    auto garment = readGarment(arguments, progress, err);
    if (!garment) {
        err << "toile: " << sentence(garment.error()) << '\n';
        return std::nullopt;
    }
    return std::move(*garment);
}

Result<Garment> readGarment(const Arguments& arguments, Progress& progress, std::ostream& err) {
    const auto loading = loadingOf(arguments, err);
    if (!loading) {
        return loading.error();
    }
    auto garment = loadGarment(arguments.inputs, *loading, progress);
    if (!garment) {
        return garment;
    }
    printDifferences(arguments, *garment, err);
    return arguments.project ? named(std::move(*garment), arguments.project->labels)
                             : std::move(*garment);
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

int refuse(const Refusal& refusal, std::ostream& err) {
    err << "toile: " << refusal.message << '\n';
    return kExitUnreadable;
}

bool printProblems(const Garment& garment, std::ostream& err) {
    bool failed = false;
    for (const auto& file : garment.files) {
        for (const Error& problem : file->problems) {
            err << "toile: " << sentence(problem) << '\n';
        }
    }
    for (const Error& problem : garment.problems) {
        err << "toile: " << sentence(problem) << '\n';
        failed = failed || !isNote(problem.code);
    }
    return failed;
}

void printTable(const ReportTable& table, std::ostream& out) {
    Table printed(table.head);
    for (const auto& row : table.rows) {
        printed.add(row);
    }
    printed.print(out);
}

bool printFailures(const PieceResults& results, std::ostream& err) {
    bool failed = false;
    for (const auto& result : results) {
        if (result->error && !isLeftOut(*result)) {
            err << "toile: " << sentence(*result->error) << '\n';
            failed = true;
        }
        failed = failed || breaksPromise(*result) || crossesItself(*result);
        if (result->flat) {
            for (const Error& note : result->flat->notes) {
                err << "toile: " << sentence(note) << '\n';
            }
        }
    }
    return failed;
}

void printPatternNotes(const std::filesystem::path& path, const PatternFile& file,
                       std::ostream& err) {
    for (const Wording& note : file.notes) {
        err << "toile: " << shownText(path.string(), kMaxOfPlace) << ": "
            << shownText(note, kMaxOfDetail) << '\n';
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
