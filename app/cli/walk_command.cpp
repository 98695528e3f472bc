// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/formats/tables/report_tables.h"
#include "core/pattern/walk.h"

namespace toile::app {
namespace {

using Notches = std::vector<std::vector<Notch>>;

/// One line: how many seams and notches there are, and by how much the worst does not fit.
void printSummary(const Garment& garment, const Notches& notches,
                  const std::vector<SeamWalk>& walks, std::ostream& out) {
    const auto worst = std::ranges::max_element(walks, {}, &SeamWalk::largestError);
    if (worst == walks.end()) {
        out << "no seam to walk\n";
        return;
    }
    long long count = 0;
    for (const auto& ofSeam : notches) {
        count += static_cast<long long>(ofSeam.size());
    }
    const Seam& seam = garment.seams.seams[static_cast<std::size_t>(worst->seam)];
    out << counted(static_cast<long long>(walks.size()), "seam") << ", "
        << (count == 1 ? "1 notch" : std::to_string(count) + " notches") << ", largest error "
        << fixed(worst->largestError(), 6) << " mm (" << shownText(seam.name) << ")\n";
}

}  // namespace

int runWalk(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    Progress progress;
    const auto garment = readInput(arguments, progress, err);
    if (!garment) {
        return kExitUnreadable;
    }
    const LineSettings& lines = arguments.lines;
    const PieceResults results = flattened(arguments, *garment, progress);
    const auto [notches, walks] = walkGarment(
        *garment, results, makePattern(*garment, results, lines, symmetryOf(*garment, lines)),
        lines.notches);
    if (arguments.json) {
        out << writeWalk(*garment, notches, walks);
    } else {
        printTable(walkTable(*garment, notches, walks), out);
        printSummary(*garment, notches, walks, out);
    }
    const bool areProblems = printProblems(*garment, err);
    const bool areFailures = printFailures(results, err);
    const bool areUnequal = std::ranges::any_of(
        walks, [](const SeamWalk& walk) { return !(walk.largestError() <= kWalkTolerance); });
    out.flush();
    return !out                                       ? kExitUnreadable
           : areProblems || areFailures || areUnequal ? kExitSomeFailed
                                                      : kExitDone;
}

}  // namespace toile::app
