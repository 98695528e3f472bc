// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <ostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/ledger.h"
#include "app/cli/project_input.h"
#include "app/cli/table.h"
#include "core/base/text.h"
#include "core/pipeline/pipeline.h"

namespace toile {
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
        row.insert(row.end(), {"-", "-", "-", "-", "-", "-", "-", "failed"});
        return row;
    }
    const PieceQuality& q = *result.quality;
    row.insert(
        row.end(),
        {fixed(q.area2d / kSquareMillimetresPerSquareCentimetre, 1),
         fixed(q.perimeter2d / kMillimetresPerCentimetre, 1), scientific(q.maxBoundaryLengthError),
         percent(q.strainMeanAbs), percent(q.strainMax), std::to_string(q.flippedTriangles),
         std::to_string(q.outlineCrossings), fixed(kMillisecondsPerSecond * result.seconds, 1)});
    return row;
}

void printTable(const PieceResults& results, std::ostream& out) {
    Table table({"piece", "triangles", "area cm2", "outline cm", "length error", "strain % mean",
                 "max", "flips", "crossings", "ms"});
    for (const auto& result : results) {
        table.add(rowOf(*result));
    }
    table.print(out);
}

}  // namespace

int runFlatten(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    Progress progress;
    const auto garment = readInput(arguments, progress, err);
    if (!garment) {
        return kExitUnreadable;
    }
    const PieceResults results = flattenGarment(*garment, arguments.options, progress);
    printCuts(*garment, out);
    printTable(results, out);
    printSeamSummary(*garment, results, out);
    if (arguments.ledger) {
        out << '\n';
        printLedger(*garment, results, out);
    }
    int status = printProblems(*garment, err) ? kExitSomeFailed : kExitDone;
    if (printFailures(results, err)) {
        const bool lacksMemory = std::ranges::any_of(results, [](const auto& result) -> bool {
            return result->error && result->error->code == ErrorCode::OutOfMemory;
        });
        status = lacksMemory ? kExitUnreadable : kExitSomeFailed;
    }
    const auto places = placesOnSheet(arguments, *garment, results);
    for (const auto& output : arguments.outputs) {
        const auto written = exportFile(output, *garment, results, places);
        if (written) {
            out << "wrote " << output.string() << '\n';
        } else {
            err << "toile: " << sentence(written.error()) << '\n';
            status = kExitUnreadable;
        }
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile
