// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/check/readiness.h"

#include <algorithm>

#include "core/base/text.h"

namespace toile {

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
    switch (verdict) {
        case Verdict::NotFlattened:
            return "not-flattened";
        case Verdict::Faults:
            return "faults";
        case Verdict::Doubts:
            return "doubts";
        case Verdict::Ready:
            return "ready";
    }
    return "";
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

}  // namespace toile
