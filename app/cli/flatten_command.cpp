// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/write_patterns.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/diagnose/doubt.h"
#include "core/formats/tables/report_tables.h"
#include "core/seam/seam_measure.h"
#include "core/symmetry/symmetry.h"
#include "core/toile/pipeline.h"

namespace toile::app {
namespace {

constexpr double kSquareMillimetresPerSquareCentimetre = 100;
constexpr double kMillimetresPerCentimetre = 10;
constexpr double kMillisecondsPerSecond = 1000;

/// A boundary error spans ten powers of ten: one digit and the power say it best.
std::string scientific(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0e", value);
    return text;
}

std::string percent(const std::optional<double>& fraction) {
    return fraction ? fixed(100 * *fraction, 2) : "-";
}

std::vector<std::string> rowOf(const PieceResult& result) {
    const Piece& piece = *result.piece;
    std::vector<std::string> row{piece.name, std::to_string(piece.mesh.F.rows())};
    if (!result.quality) {
        row.insert(row.end(), {"-", "-", "-", "-", "-", "-", "-", "-", "-",
                               isLeftOut(result) ? "left out" : "failed"});
        return row;
    }
    const PieceQuality& q = *result.quality;
    const std::string changes = changeWords(changesOf(result));
    row.insert(row.end(), {fixed(q.area2d / kSquareMillimetresPerSquareCentimetre, 1),
                           fixed(q.perimeter2d / kMillimetresPerCentimetre, 1),
                           scientific(q.maxBoundaryLengthError), changes.empty() ? "-" : changes,
                           percent(q.strainMin), percent(q.strainMax), percent(q.strainMeanAbs),
                           std::to_string(q.flippedTriangles), std::to_string(q.outlineCrossings),
                           fixed(kMillisecondsPerSecond * result.seconds, 1)});
    return row;
}

void printResults(const PieceResults& results, std::ostream& out) {
    Table table({"piece", "triangles", "area cm2", "outline cm", "length error", "changed by",
                 "strain % least", "most", "mean size", "flips", "crossings", "ms"});
    for (const auto& result : results) {
        table.add(rowOf(*result));
    }
    table.print(out);
}

/// One line: how many seams there are, and by how much the worst of them does not fit.
void printSeamSummary(const Garment& garment, const PieceResults& results, std::ostream& out) {
    const std::vector<MeasuredSeam> rows = seamsByError(garment, results);
    if (rows.empty()) {
        return;
    }
    out << counted(static_cast<long long>(rows.size()), "seam") << ", largest error "
        << fixed(std::abs(rows.front().measure.errorMm), 2) << " mm ("
        << shownText(rows.front().seam->name) << ")\n";
}

/// The pieces that are not mirrored since their seams differ too much, and what makes them equal.
void printUnequal(const Garment& garment, const Symmetry* symmetry, std::ostream& out) {
    if (!symmetry || symmetry->kept.empty() || symmetry->unequal.empty()) {
        return;
    }
    const auto seamName = [&garment](int seam) -> std::string {
        return shownText(garment.seams.seams[seam].name);
    };
    for (const UnequalPieces& one : symmetry->unequal) {
        out << "not mirrored: " << shownText(garment.pieces[one.piece]->name);
        if (one.piece == one.counterpart) {
            out << ", its two halves";
        } else {
            out << " and " << shownText(garment.pieces[one.counterpart]->name);
        }
        out << "; seam " << seamName(one.seam) << " is " << fixed(one.difference, 1)
            << " mm longer than " << seamName(one.mirrored) << " (tolerance "
            << fixed(one.tolerance, 1) << " mm)\n";
    }
    out << "they keep their shapes from the file; use --mirror equal to make them equal\n";
}

}  // namespace

int runFlatten(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    Progress progress;
    const auto garment = readInput(arguments, progress, err);
    if (!garment) {
        return kExitUnreadable;
    }
    const PieceResults results = flattened(arguments, *garment, progress);
    printCuts(*garment, out);
    printResults(results, out);
    printSeamSummary(*garment, results, out);
    if (arguments.ledger) {
        out << '\n';
        printTable(ledgerTable(*garment, results), out);
    }
    printProblems(*garment, err);
    printFailures(results, err);
    const FinishedPattern made = finished(arguments, *garment, results);
    const Pattern& pattern = made.laid.pattern;
    printUnequal(*garment, pattern.symmetry.get(), out);
    const auto doubts = findDoubts(*garment, results, fabricsOf(pattern, made.fabric));
    for (const Finding& doubt : doubts) {
        err << "toile: " << name(doubt.severity) << ": " << sentence(doubt) << '\n';
    }
    const bool lacksMemory = std::ranges::any_of(results, [](const auto& result) -> bool {
        return result->error && result->error->code == ErrorCode::OutOfMemory;
    });
    const bool isRefused =
        hasFaults(*garment, results, doubts) || (arguments.failOnDoubt && !doubts.empty());
    int status = lacksMemory ? kExitUnreadable : isRefused ? kExitSomeFailed : kExitDone;
    if (!writePatterns(arguments.outputs, made.source(arguments.exporting), out, err)) {
        status = kExitUnreadable;
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile::app
