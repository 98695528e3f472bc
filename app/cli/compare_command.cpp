// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>
#include <utility>

#include "app/cli/command_line.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/formats/read_pattern.h"
#include "core/formats/tables/comparison_writer.h"
#include "core/formats/tables/pattern_match.h"
#include "core/formats/writers.h"
#include "core/prove/proof.h"
#include "core/toile/pipeline.h"

namespace toile::app {
namespace {

void print(const ComparisonTable& compared, std::ostream& out) {
    out << readableName(compared.title) << '\n';
    Table table(compared.head);
    for (const auto& row : compared.rows) {
        table.add(row);
    }
    table.print(out);
}

void printText(const Garment& garment, const Comparison& comparison, bool perPiece,
               std::ostream& out) {
    printCuts(garment, out);
    const auto tables = comparisonTables(garment, comparison, perPiece);
    print(tables.front(), out);
    if (const std::string sentence = nearerSentence(comparison); !sentence.empty()) {
        out << sentence << '\n';
    }
    for (std::size_t k = 1; k < tables.size(); ++k) {
        out << '\n';
        print(tables[k], out);
    }
}

/// Sews the pattern of each method back together and measures its distance from the design.
/// @return whether one could not be sewn, which is reported
bool proveMethods(const Arguments& arguments, const Garment& garment, Comparison& comparison,
                  Progress& progress, Messages& messages) {
    const auto ordered = orderOfOwn(arguments, garment, progress);
    if (!ordered) {
        refuse(ordered.refusal(), messages);
        return true;
    }
    Arguments exact = arguments;  // compare methods by their exact outlines
    exact.lines = {};
    bool failed = false;
    for (ComparedMethod& method : comparison.methods) {
        const FinishedPattern made = finished(exact, garment, method.results);
        const auto proof = proofOf(made.source(), *ordered,
                                   Progress(progress, 1.0 / double(comparison.methods.size())));
        if (!proof) {
            messages.add(std::string(name(method.method)) + ": " +
                         refusalOfProof(proof.error(), method.results).message);
            failed = true;
            continue;
        }
        method.figures[Criterion::SewnGap] = (*proof)->gap.mean;
        for (std::size_t p = 0; p < method.pieceFigures.size(); ++p) {
            if ((*proof)->pieces[p].isSewn()) {
                method.pieceFigures[p][Criterion::SewnGap] = (*proof)->pieces[p].gapFigures.mean;
            }
        }
    }
    return failed;
}

/// Reports each piece that failed or breaks its method's guarantee, once per method. Reports
/// defects of the piece itself once. @return whether there was one
bool reportFailures(const Garment& garment, const Comparison& comparison, Messages& messages) {
    bool failed = false;
    for (std::size_t k = 0; k < garment.pieces.size(); ++k) {
        const bool isOut = std::ranges::any_of(
            comparison.methods,
            [k](const ComparedMethod& method) { return isLeftOut(*method.results[k]); });
        if (garment.pieces[k]->defect && !isOut) {
            messages.add(*garment.pieces[k]->defect);
            failed = true;
        }
    }
    for (const ComparedMethod& method : comparison.methods) {
        for (const auto& result : method.results) {
            const auto say = [&](const Error& error) {
                messages.add(std::string(name(method.method)) + ": " + sentence(error));
                failed = true;
            };
            if (result->error && !result->piece->defect && !isLeftOut(*result)) {
                say(*result->error);
            }
            if (breaksPromise(*result)) {
                say(*std::ranges::find(result->flat->notes, ErrorCode::TrianglesFlipped,
                                       &Error::code));
            }
        }
    }
    return failed;
}

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
        for (const LineMatch& line : pair.lines) {
            table.add({pattern.pieces[static_cast<std::size_t>(pair.piece)].name,
                       other.name + (other.size.empty() ? "" : " (" + other.size + ")"),
                       std::string(name(pair.by)) + (pair.isDoubtful() ? "?" : ""), linesText(line),
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
        } else if (pair.isDoubtful()) {
            out << shownText(ourPiece(pair.piece)) << " may not be \""
                << shownText(filePiece(pair.filePiece))
                << "\": their sizes or shapes differ much\n";
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

/// Uses the named method if there is exactly one, else the default.
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

/// With `--pattern`: compares with a pattern from a file.
int comparePattern(const Arguments& arguments, std::ostream& out, Messages& messages) {
    const auto file = readPatternFile(arguments.pattern);
    if (!file) {
        messages.add(file.error());
        return kExitUnreadable;
    }
    reportPatternNotes(arguments.pattern, *file, messages);
    Progress progress;
    const auto garment = readInput(arguments, progress, messages);
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
    status = reportProblems(*garment, messages) || reportFailures(results, messages)
                 ? kExitSomeFailed
                 : status;
    for (const auto& output : arguments.outputs) {
        const auto written = writeFile(output, writeSvg(drawPatternMatch(pattern, *file, match)));
        if (written) {
            messages.stream() << "wrote " << output.string() << '\n';
        } else {
            messages.add(written.error());
            status = kExitUnreadable;
        }
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace

int runCompare(const Arguments& arguments, std::ostream& out, Messages& messages) {
    if (!arguments.pattern.empty()) {
        return comparePattern(arguments, out, messages);
    }
    Progress progress;
    const auto garment = readInput(arguments, progress, messages);
    if (!garment) {
        return kExitUnreadable;
    }
    Comparison comparison =
        compareMethods(*garment, arguments.methods, arguments.options, progress);
    for (ComparedMethod& method : comparison.methods) {
        method = compared(method.method, *garment,
                          withoutLeftOut(arguments, *garment, std::move(method.results)));
    }
    bool undone =
        arguments.isProving && proveMethods(arguments, *garment, comparison, progress, messages);
    if (arguments.json) {
        out << writeComparison(*garment, comparison);
    } else if (arguments.markdown) {
        out << writeComparisonMarkdown(*garment, comparison, arguments.perPiece);
    } else {
        printText(*garment, comparison, arguments.perPiece, out);
    }
    undone = reportProblems(*garment, messages) || undone;
    const bool failed = reportFailures(*garment, comparison, messages);
    out.flush();
    return !out ? kExitUnreadable : undone || failed ? kExitSomeFailed : kExitDone;
}

}  // namespace toile::app
