// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/advice_table.h"

#include <algorithm>
#include <numbers>
#include <ostream>

#include "app/cli/arguments.h"
#include "app/cli/input.h"
#include "core/base/text.h"
#include "core/garment/opening_cuts.h"
#include "core/pipeline/solve_advice.h"
#include "core/tailor/file_borders.h"

namespace toile::app {
namespace {

std::string percent(double part) {
    return fixed(100 * part, part < 0.01 ? 2 : 1);
}

std::string textOf(const std::optional<DartIntake>& intake) {
    return intake ? fixed(intake->width, 0) + " mm, " +
                        fixed(intake->angle * 180 / std::numbers::pi, 0) + " deg"
                  : "";
}

/// The user's cuts in a piece.
std::vector<UserCut> ownCutsOf(const Garment& garment, const std::shared_ptr<const Piece>& piece) {
    const auto record = std::ranges::find(garment.cutRecords, piece, &CutRecord::whole);
    return record == garment.cutRecords.end() ? std::vector<UserCut>{} : record->asked;
}

void printFor(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>& own,
              const PolygonSoup& soup, const Arguments& arguments, Progress& progress,
              std::ostream& out) {
    const CutAdvice advice = adviseCuts(
        piece, own,
        {arguments.load.isFrontSwapped, arguments.load.enoughStrain, fileBorders(*piece, soup)},
        progress);
    out << piece->name << ": ";
    if (advice.cuts.empty()) {
        out << "no cut is worth its length\n\n";
        return;
    }
    const auto solvedAfter = [&](std::size_t count) {
        const auto solved = solvedStrain(piece, own, advice, count, arguments.options, progress);
        return solved ? percent(solved->mean) : std::string("-");
    };
    out << "strain " << percent(advice.before.mean) << " % foretold, " << solvedAfter(0)
        << " % solved with the fewest cuts; less by these, the best first\n";
    Table table(
        {"cut", "length mm", "in all mm", "strain %", "solved %", "takes in", "enough", "because"});
    double inAll = 0;
    for (std::size_t k = 0; k < advice.cuts.size(); ++k) {
        const AdvisedCut& cut = advice.cuts[k];
        inAll += cut.length;
        table.add({cut.what.cut.name, fixed(cut.length, 0), fixed(inAll, 0),
                   percent(cut.predicted.mean), k < kSolvedAhead ? solvedAfter(k + 1) : "",
                   textOf(cut.intake), cut.isNeeded ? "yes" : "", cut.evidence});
    }
    table.print(out);
    out << '\n';
}

}  // namespace

void printAdvice(const Arguments& arguments, const Garment& garment, Progress& progress,
                 std::ostream& out) {
    for (const auto& piece : garment.uncut) {
        if (piece->defect && !isOpenable(*piece)) {
            out << piece->name << ": cuts do not help, " << describe(piece->defect->code) << "\n\n";
            continue;
        }
        printFor(piece, ownCutsOf(garment, piece),
                 *garment.files[static_cast<std::size_t>(piece->file)]->soup, arguments, progress,
                 out);
    }
}

}  // namespace toile::app
