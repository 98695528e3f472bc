// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/export/export_file.h"
#include "core/pipeline/pipeline.h"
#include "core/seam/seam_measure.h"

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

struct MeasuredSeam {
    const Seam* seam;
    SeamMeasure measure;
};

/// The seams of which both sides are flat, the worst first.
std::vector<MeasuredSeam> measuredSeams(const Garment& garment, const PieceResults& results) {
    std::vector<MeasuredSeam> rows;
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind == SeamKind::Free) {
            continue;
        }
        const PieceResult& left = *results[seam.left.piece];
        const PieceResult& right = *results[seam.right.piece];
        if (left.flat && right.flat) {
            rows.push_back(
                {&seam, measureSeam(seam, *left.piece, *left.flat, *right.piece, *right.flat)});
        }
    }
    // Rounding is no order: equal errors stay in the order of the seams.
    const auto nanometres = [](const MeasuredSeam& row) {
        return std::round(std::abs(row.measure.errorMm) * 1e6);
    };
    std::stable_sort(rows.begin(), rows.end(),
                     [&nanometres](const MeasuredSeam& a, const MeasuredSeam& b) {
                         return nanometres(a) > nanometres(b);
                     });
    return rows;
}

/// The seams as a table, the worst first: how long their two sides are in the garment and in the
/// pattern. Free edges are left out.
void printLedger(const Garment& garment, const PieceResults& results, std::ostream& out) {
    Table table(
        {"seam", "kind", "3D mm", "left mm", "right mm", "difference mm", "ease %", "error mm"});
    for (const auto& [seam, measure] : measuredSeams(garment, results)) {
        table.add({seam->name, std::string(name(seam->kind)), fixed(measure.length3d[0], 2),
                   fixed(measure.length2dLeft, 2), fixed(measure.length2dRight, 2),
                   fixed(measure.deltaMm, 2), fixed(100 * measure.ease, 1),
                   fixed(measure.errorMm, 6)});
    }
    table.print(out);
}

/// One line: how many seams there are, and by how much the worst of them does not fit.
void printSeamSummary(const Garment& garment, const PieceResults& results, std::ostream& out) {
    const std::vector<MeasuredSeam> rows = measuredSeams(garment, results);
    if (rows.empty()) {
        return;
    }
    out << counted(static_cast<long long>(rows.size()), "seam") << ", largest error "
        << fixed(std::abs(rows.front().measure.errorMm), 2) << " mm ("
        << shownText(rows.front().seam->name) << ")\n";
}

}  // namespace

int runFlatten(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    Progress progress;
    const auto garment = readInput(arguments, progress, err);
    if (!garment) {
        return kExitUnreadable;
    }
    const PieceResults results =
        flattenGarment(*garment, arguments.options, progress, 0, arguments.lines);
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
    const LaidOutPattern laid = laidOut(arguments, *garment, results);
    const ExportSource source(*garment, results, laid, arguments.exporting);
    for (const auto& output : arguments.outputs) {
        const auto written = exportFile(output, source);
        if (written) {
            for (const std::filesystem::path& file : written->files) {
                out << "wrote " << file.string();
                if (written->readBack && file == written->files.front()) {
                    out << "; " << readBackSentence(*written->readBack);
                }
                out << '\n';
            }
        } else {
            err << "toile: " << sentence(written.error()) << '\n';
            status = kExitUnreadable;
        }
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile::app
