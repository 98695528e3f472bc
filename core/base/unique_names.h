// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

namespace toile {

/// Gives each thing a name of its own: as wanted, or with a number. n log n, also where thousands
/// want the same.
class UniqueNames {
public:
    /// A name that is not to be given.
    void take(const std::string& name) { taken_.insert(name); }

    bool isFree(const std::string& name) const { return !taken_.contains(name); }

    /// The name itself where it is free, else with a number from 2 on.
    /// @param before  what stands before the number
    std::string free(const std::string& wanted, const char* before = " ") {
        return taken_.insert(wanted).second ? wanted : numbered(wanted, before, 2);
    }

    /// With a number whatever is free: where there will be more.
    std::string numbered(const std::string& wanted, const char* before = " ", int first = 1) {
        for (int& next = nextNumber_.try_emplace(wanted, first).first->second;;) {
            std::string name = wanted + before + std::to_string(next++);
            if (taken_.insert(name).second) {
                return name;
            }
        }
    }

private:
    std::set<std::string> taken_;
    std::map<std::string, int> nextNumber_;
};

}  // namespace toile
