// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/proof_order.h"
#include "app/cli/write_patterns.h"
#include "core/base/characters.h"
#include "core/formats/tables/comparison_writer.h"
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

/// Sews the pattern of each method back together, and notes how far it sits from the design.
/// @return whether one could not be sewn, of which a sentence is printed
bool proveMethods(const Arguments& arguments, const Garment& garment, Comparison& comparison,
                  Progress& progress, std::ostream& err) {
    const auto ordered = orderOfOwn(arguments, garment, progress);
    if (const auto* refusal = std::get_if<Refusal>(&ordered)) {
        refuse(*refusal, err);
        return true;
    }
    Arguments exact = arguments;  // methods are compared by their exact outlines
    exact.lines = {};
    bool failed = false;
    for (ComparedMethod& method : comparison.methods) {
        const FinishedPattern made = finished(exact, garment, method.results);
        const auto proof = proofOf(made.source(), std::get<ProofOrder>(ordered),
                                   Progress(progress, 1.0 / double(comparison.methods.size())));
        if (!proof) {
            err << "toile: " << name(method.method) << ": "
                << refusalOfProof(proof.error(), method.results).message << '\n';
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

/// A sentence for each piece that failed, or is flipped against the method's promise, with
/// the method where it did so under it; one where the piece itself is at fault.
/// @return whether there was one
bool printFailures(const Garment& garment, const Comparison& comparison, std::ostream& err) {
    bool failed = false;
    for (std::size_t k = 0; k < garment.pieces.size(); ++k) {
        const bool isOut = std::ranges::any_of(
            comparison.methods,
            [k](const ComparedMethod& method) { return isLeftOut(*method.results[k]); });
        if (garment.pieces[k]->defect && !isOut) {
            err << "toile: " << sentence(*garment.pieces[k]->defect) << '\n';
            failed = true;
        }
    }
    for (const ComparedMethod& method : comparison.methods) {
        for (const auto& result : method.results) {
            const auto say = [&](const Error& error) {
                err << "toile: " << name(method.method) << ": " << sentence(error) << '\n';
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

}  // namespace

int runCompare(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    if (!arguments.pattern.empty()) {
        return runComparePattern(arguments, out, err);
    }
    Progress progress;
    const auto garment = readInput(arguments, progress, err);
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
        arguments.isProving && proveMethods(arguments, *garment, comparison, progress, err);
    if (arguments.json) {
        out << writeComparison(*garment, comparison);
    } else if (arguments.markdown) {
        out << writeComparisonMarkdown(*garment, comparison, arguments.perPiece);
    } else {
        printText(*garment, comparison, arguments.perPiece, out);
    }
    undone = printProblems(*garment, err) || undone;
    const bool failed = printFailures(*garment, comparison, err);
    out.flush();
    return !out ? kExitUnreadable : undone || failed ? kExitSomeFailed : kExitDone;
}

}  // namespace toile::app
