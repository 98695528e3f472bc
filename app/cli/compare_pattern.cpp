// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/formats/read_pattern.h"
#include "core/formats/tables/pattern_match.h"
#include "core/formats/writers.h"
#include "core/toile/pipeline.h"

namespace toile::app {
namespace {

constexpr int kMatchDecimals = 2;

std::string linesText(const LineMatch& line) {
    const auto word = [](MatchedLine which) {
        return which == MatchedLine::Cut ? std::string("cut") : std::string("seam");
    };
    return line.ours == line.theirs ? word(line.ours)
                                    : word(line.ours) + " with " + word(line.theirs);
}

std::string changeText(double ours, double theirs) {
    return theirs > 0 ? fixed(100 * (ours / theirs - 1), kMatchDecimals) : "-";
}

void printPairs(const Pattern& pattern, const PatternFile& file, const PatternMatch& match,
                std::ostream& out) {
    Table table({"piece", "in the file", "paired by", "line", "mean mm", "farthest mm", "length mm",
                 "in the file mm", "length %", "area %", "mirrored"});
    for (const PieceMatch& pair : match.pairs) {
        const FilePiece& other = file.pieces[static_cast<std::size_t>(pair.filePiece)];
        const bool isDoubtful = !pair.rivals.empty();
        for (const LineMatch& line : pair.lines) {
            table.add({pattern.pieces[static_cast<std::size_t>(pair.piece)].name,
                       other.name + (other.size.empty() ? "" : " (" + other.size + ")"),
                       std::string(name(pair.by)) + (isDoubtful ? "?" : ""), linesText(line),
                       fixed(line.fit.mean, kMatchDecimals),
                       fixed(line.fit.farthest, kMatchDecimals), fixed(line.lengthOurs, 1),
                       fixed(line.lengthTheirs, 1), changeText(line.lengthOurs, line.lengthTheirs),
                       changeText(line.areaOurs, line.areaTheirs), line.fit.mirrored ? "yes" : ""});
        }
    }
    table.print(out);
}

void printRest(const Pattern& pattern, const PatternFile& file, const PatternMatch& match,
               std::ostream& out) {
    constexpr std::size_t kNamed = 10;
    const auto filePiece = [&file](int k) { return file.pieces[static_cast<std::size_t>(k)].name; };
    const auto ourPiece = [&pattern](int k) {
        return pattern.pieces[static_cast<std::size_t>(k)].name;
    };
    const auto listOf = [](const std::vector<int>& pieces, const auto& nameOf) {
        std::vector<std::string> names;
        std::ranges::transform(pieces, std::back_inserter(names), nameOf);
        return quotedList(names, kNamed);
    };
    for (const PieceMatch& pair : match.pairs) {
        if (!pair.rivals.empty()) {
            out << shownText(ourPiece(pair.piece)) << " fits " << listOf(pair.rivals, filePiece)
                << " about as well as \"" << shownText(filePiece(pair.filePiece)) << "\"\n";
        }
    }
    if (!match.alone.empty()) {
        out << "pieces without a match: " << listOf(match.alone, ourPiece) << '\n';
    }
    if (!match.aloneInFile.empty()) {
        out << "only in the file: " << listOf(match.aloneInFile, filePiece) << '\n';
    }
    const bool hasOnlyOne = std::ranges::any_of(match.pairs, [](const PieceMatch& pair) {
        return std::ranges::any_of(pair.lines,
                                   [](const LineMatch& line) { return line.ours != line.theirs; });
    });
    if (hasOnlyOne) {
        out << "the file has one line per piece, used as the seam line because the pattern has no "
               "allowance\n";
    }
}

/// By the one method that was named, else the usual one.
FlattenOptions chosenOptions(const Arguments& arguments) {
    FlattenOptions options = arguments.options;
    if (arguments.methods.size() == 1) {
        options.method = arguments.methods.front();
    }
    return options;
}

bool isAllPaired(const PatternMatch& match) {
    return match.alone.empty() && match.aloneInFile.empty();
}

}  // namespace

int runComparePattern(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    const auto file = readPatternFile(arguments.pattern);
    if (!file) {
        err << "toile: " << sentence(file.error()) << '\n';
        return kExitUnreadable;
    }
    printPatternNotes(arguments.pattern, *file, err);
    Progress progress;
    const auto garment = readInput(arguments, progress, err);
    if (!garment) {
        return kExitUnreadable;
    }
    const PieceResults results =
        flattenGarment(*garment, chosenOptions(arguments), progress, 0, arguments.lines);
    const FinishedPattern made = finished(arguments, *garment, results);
    const Pattern& pattern = made.laid.wholePattern;
    const PatternMatch match = matchPatterns(pattern, *file);
    if (arguments.json) {
        out << writePatternMatch(pattern, *file, match);
    } else {
        out << shownText(arguments.pattern.string(), kMaxOfPlace) << ": " << file->format
            << ", unit " << unitText(file->unit);
        if (!file->unitReason.empty()) {
            out << " (" << file->unitReason << (file->unitInDoubt ? "; uncertain" : "") << ")";
        }
        out << "\n\n";
        printPairs(pattern, *file, match, out);
        printRest(pattern, *file, match, out);
    }
    int status = isAllPaired(match) ? kExitDone : kExitSomeFailed;
    status = printProblems(*garment, err) || printFailures(results, err) ? kExitSomeFailed : status;
    for (const auto& output : arguments.outputs) {
        const auto written = writeFile(output, writeSvg(drawPatternMatch(pattern, *file, match)));
        if (written) {
            err << "wrote " << output.string() << '\n';
        } else {
            err << "toile: " << sentence(written.error()) << '\n';
            status = kExitUnreadable;
        }
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile::app
