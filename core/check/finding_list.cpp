// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/finding_list.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace toile {

void FindingList::add(Finding finding, double badness) {
    found_.push_back({std::move(finding), badness});
}

void FindingList::add(const Error& error, std::vector<int> pieces) {
    Finding finding;
    finding.severity = isNote(error.code) ? Severity::Note : Severity::Fault;
    finding.where = error.where;
    finding.pieces = std::move(pieces);
    finding.error = error;
    add(std::move(finding));
}

Readiness FindingList::inOrder() {
    std::ranges::stable_sort(found_, [](const Rated& a, const Rated& b) -> bool {
        return std::tuple(a.finding.severity, a.finding.kind, -a.badness) <
               std::tuple(b.finding.severity, b.finding.kind, -b.badness);
    });
    Readiness readiness;
    for (Rated& rated : found_) {
        readiness.findings.push_back(std::move(rated.finding));
    }
    found_.clear();
    return readiness;
}

}  // namespace toile
