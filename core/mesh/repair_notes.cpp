// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/mesh/repair_steps.h"

namespace toile {

void RepairNotes::add(ErrorCode code, std::string_view noun, const char* what,
                      const Eigen::RowVector3d& place) {
    for (Entry& entry : entries_) {
        if (entry.code == code && entry.noun == noun && entry.what == std::string_view(what)) {
            ++entry.count;
            return;
        }
    }
    entries_.push_back({code, noun, what, place, 1});
}

Problems RepairNotes::problems(const std::string& where) const {
    std::vector<Entry> sorted = entries_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Entry& a, const Entry& b) { return a.code < b.code; });
    Problems problems;
    for (const Entry& entry : sorted) {
        Wording text = toile::worded(
            "%1 %2", {countWording(entry.count, entry.noun), toile::worded(entry.what)});
        if (entry.first.allFinite()) {
            text += entry.count == 1 ? toile::worded(", at ") : toile::worded(", the first at ");
            text += toile::worded("%1, %2, %3 mm",
                                  {figure(entry.first.x(), 1), figure(entry.first.y(), 1),
                                   figure(entry.first.z(), 1)});
        }
        if (!problems.empty() && problems.back().code == entry.code) {
            problems.back().detail += "; ";
            problems.back().detail += text;
        } else {
            problems.push_back({entry.code, where, text});
        }
    }
    return problems;
}

}  // namespace toile
