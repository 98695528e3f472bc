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
    NotFlattened,  ///< there is no pattern of the garment as it is now
    Faults,
    Doubts,  ///< no faults, but something to look at
    Ready,
};

/// What was found, the faults first, then by kind, the worst of a kind first.
struct Readiness {
    std::vector<Finding> findings{};
    std::vector<ClothNeed> cloth{};  ///< of what is flat; none where there is no pattern

    int count(Severity severity) const;
    Verdict verdict() const;
};

/// "not-flattened", "faults", "doubts", "ready".
std::string_view name(Verdict verdict);
/// "Ready to cut", "2 faults, 1 doubt", "No faults, 3 doubts", "Not flattened yet".
std::string verdictText(const Readiness& readiness);

/// Gathers findings and brings them in order.
class FindingList {
public:
    /// @param badness  orders those of one severity and kind, the worst first
    void add(Finding finding, double badness = 0);
    /// What an error or a note says: a fault or a note, as its code has it.
    void add(const Error& error, std::vector<int> pieces);
    /// All of them, once: the list is empty then. Those alike stay in the order they came in.
    Readiness inOrder();

private:
    struct Rated {
        Finding finding;
        double badness;
    };

    std::vector<Rated> found_;
};

}  // namespace toile
