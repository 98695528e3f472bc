// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/check/finding.h"
#include "core/layout/cloth_need.h"

namespace toile {

/// Whether the cloth may be cut.
enum class Verdict {
    NotFlattened,  ///< the garment in its present state has no pattern
    Faults,
    Doubts,  ///< no faults, but something to check
    Ready,
};

/// All findings: the faults first, then by kind, the worst of a kind first.
struct Readiness {
    std::vector<Finding> findings{};
    std::vector<ClothNeed> cloth{};  ///< of flat pieces; empty without a pattern

    int count(Severity severity) const;
    Verdict verdict() const;
};

/// "not-flattened", "faults", "doubts", "ready".
std::string_view name(Verdict verdict);
/// "Ready to cut", "2 faults, 1 doubt", "No faults, 3 doubts", "Not flattened yet".
std::string verdictText(const Readiness& readiness);

/// Collects findings and sorts them.
class FindingList {
public:
    /// @param badness  orders findings of one severity and kind, the worst first
    void add(Finding finding, double badness = 0);
    /// Adds an error or a note; its code decides whether it is a fault or a note.
    void add(const Error& error, std::vector<int> pieces);
    /// Takes all findings and leaves the list empty. Equal ones keep the order they were added in.
    Readiness inOrder();

private:
    struct Rated {
        Finding finding;
        double badness;
    };

    std::vector<Rated> found_;
};

}  // namespace toile
