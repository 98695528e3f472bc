// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace toile {

/// Counts what a reader meets, so that a file with a thousand faults of a kind gives one message
/// with the count and the first place.
class ProblemTally {
public:
    /// `placeWord` names what places are: "line", "face".
    explicit ProblemTally(std::string_view placeWord) : placeWord_(placeWord) {}

    /// One more fault: `noun` is what it befell ("face"), `what` the fault ("left out: ..."). Both
    /// are literals.
    void add(ErrorCode code, std::string_view noun, std::string_view what, int place);

    bool empty() const { return entries_.empty(); }

    /// All faults in words: "2 faces left out: ..., first at line 7; 1 vertex ..., line 3".
    std::string summary() const;
    /// One problem per code, in order of first occurrence.
    Problems problems(const std::string& file) const;

private:
    struct Entry {
        ErrorCode code;
        std::string_view noun, what;
        int firstPlace;
        int count;
    };

    std::string inWords(const Entry& entry) const;

    std::string_view placeWord_;
    std::vector<Entry> entries_;
};

}  // namespace toile
