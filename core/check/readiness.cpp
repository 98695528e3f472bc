// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/readiness.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/base/text.h"
#include "core/base/words.h"

namespace toile {
namespace {

constexpr Word<Verdict> kVerdicts[] = {{Verdict::NotFlattened, "not-flattened"},
                                       {Verdict::Faults, "faults"},
                                       {Verdict::Doubts, "doubts"},
                                       {Verdict::Ready, "ready"}};

}  // namespace

int Readiness::count(Severity severity) const {
    return static_cast<int>(std::ranges::count(findings, severity, &Finding::severity));
}

Verdict Readiness::verdict() const {
    const bool isFlattened = std::ranges::none_of(findings, [](const Finding& finding) -> bool {
        return finding.kind == FindingKind::NotFlattened;
    });
    return !isFlattened                 ? Verdict::NotFlattened
           : count(Severity::Fault) > 0 ? Verdict::Faults
           : count(Severity::Doubt) > 0 ? Verdict::Doubts
                                        : Verdict::Ready;
}

std::string_view name(Verdict verdict) {
    return wordOf(kVerdicts, verdict);
}

std::string verdictText(const Readiness& readiness) {
    const int faults = readiness.count(Severity::Fault), doubts = readiness.count(Severity::Doubt);
    switch (readiness.verdict()) {
        case Verdict::NotFlattened:
            return "Not flattened yet";
        case Verdict::Faults:
            return counted(faults, "fault") + (doubts > 0 ? ", " + counted(doubts, "doubt") : "");
        case Verdict::Doubts:
            return "No faults, " + counted(doubts, "doubt");
        case Verdict::Ready:
            break;
    }
    return "Ready to cut";
}

void FindingList::add(Finding finding, double badness) {
    found_.push_back({std::move(finding), badness});
}

void FindingList::add(const Error& error, std::vector<int> pieces) {
    Finding finding;
    finding.severity = isNote(error.code) ? Severity::Note : Severity::Fault;
    finding.subject = error.subject;
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
