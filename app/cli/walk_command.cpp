// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>
#include <ostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "core/base/characters.h"
#include "core/base/text.h"
#include "core/export/seam_walk_writer.h"
#include "core/pattern/walk.h"

namespace toile::app {
namespace {

using Notches = std::vector<std::vector<Notch>>;

std::vector<std::string> stationRow(const std::string& seam, const SeamWalk& walk, std::size_t k,
                                    const std::vector<Notch>& notches) {
    const WalkStation& at = walk.stations[k];
    std::string mark;
    if (at.notch >= 0) {
        const Notch& notch = notches[static_cast<std::size_t>(at.notch)];
        mark = std::string(wordOf(kNotchReasonWords, notch.reason)) +
               (notch.count > 1 ? ", double" : "");
    }
    std::vector<std::string> row{k == 0 ? seam : "", std::string(stationWord(walk, k)), mark};
    if (k == 0) {
        row.insert(row.end(), 4, "");
    } else {
        row.insert(row.end(), {fixed(at.left, 2), fixed(at.right, 2), fixed(at.ease, 2),
                               fixed(at.error(), 6)});
    }
    row.push_back(at.kink ? fixed(*at.kink * 180 / std::numbers::pi, 1) : "");
    return row;
}

/// A line for each station, with the way there from the one before.
void printWalks(const Garment& garment, const Notches& notches, const std::vector<SeamWalk>& walks,
                std::ostream& out) {
    Table table(
        {"seam", "station", "mark", "left mm", "right mm", "ease mm", "error mm", "kink °"});
    for (const SeamWalk& walk : walks) {
        const auto seam = static_cast<std::size_t>(walk.seam);
        for (std::size_t k = 0; k < walk.stations.size(); ++k) {
            table.add(stationRow(garment.seams.seams[seam].name, walk, k, notches[seam]));
        }
    }
    table.print(out);
}

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
    const PieceResults results = flattenGarment(*garment, arguments.options, progress, 0, lines);
    PieceResults exact;
    for (const auto& result : results) {
        exact.push_back(result->exact ? result->exact : result);
    }
    const std::vector<OutlineSegments> segments = findSegments(*garment, exact, lines);
    const Notches notches =
        findNotches(*garment, results, segments, lines.notches.value_or(NotchRules{}),
                    symmetryOf(*garment, lines).get());
    const std::vector<SeamWalk> walks = walkSeams(*garment, results, segments, notches);
    if (arguments.json) {
        out << writeWalk(*garment, notches, walks);
    } else {
        printWalks(*garment, notches, walks, out);
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
