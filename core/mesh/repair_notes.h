// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/error.h"

namespace toile {

/// Counts what a repair does, so that a thousand faults of a kind give one note with the count and
/// the first place.
class RepairNotes {
public:
    /// One more repair: `noun` is what it befell ("face"), `what` what became of it, both literals;
    /// `what` is one for the translations (`translatable`).
    void add(ErrorCode code, std::string_view noun, const char* what,
             const Eigen::RowVector3d& place);

    bool empty() const { return entries_.empty(); }

    /// One note per code, in the order of the codes: "3 faces turned, the first at 1.0, 2.0, 0.0
    /// mm"; what differs within a code is parted by a semicolon.
    Problems problems(const std::string& where) const;

private:
    struct Entry {
        ErrorCode code;
        std::string_view noun;
        const char* what;
        Eigen::RowVector3d first;
        int count;
    };

    std::vector<Entry> entries_;
};

}  // namespace toile
