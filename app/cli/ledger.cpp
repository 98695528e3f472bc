// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/ledger.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "app/cli/table.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

struct Row {
    const Seam* seam;
    SeamMeasure measure;
};

/// The seams of which both sides are flat, the worst first.
std::vector<Row> measuredSeams(const Garment& garment, const PieceResults& results) {
    std::vector<Row> rows;
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind == SeamKind::Free) {
            continue;
        }
        const PieceResult& left = *results[seam.left.piece];
        const PieceResult& right = *results[seam.right.piece];
        if (left.flat && right.flat) {
            rows.push_back(
                {&seam, measureSeam(seam, *left.piece, left.flat->Q, *right.piece, right.flat->Q)});
        }
    }
    // Rounding is no order: equal errors stay in the order of the seams.
    const auto nanometres = [](const Row& row) {
        return std::round(std::abs(row.measure.errorMm) * 1e6);
    };
    std::stable_sort(rows.begin(), rows.end(), [&nanometres](const Row& a, const Row& b) {
        return nanometres(a) > nanometres(b);
    });
    return rows;
}

}  // namespace

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

void printSeamSummary(const Garment& garment, const PieceResults& results, std::ostream& out) {
    const std::vector<Row> rows = measuredSeams(garment, results);
    if (rows.empty()) {
        return;
    }
    out << counted(static_cast<long long>(rows.size()), "seam") << ", largest error "
        << fixed(std::abs(rows.front().measure.errorMm), 2) << " mm ("
        << shownText(rows.front().seam->name) << ")\n";
}

}  // namespace toile
