// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/check/readiness.h"

namespace toile {

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
