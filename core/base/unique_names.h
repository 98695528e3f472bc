// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

namespace toile {

/// Gives each thing a unique name: as wanted, or with a number. n log n, also if thousands want the
/// same name.
class UniqueNames {
public:
    /// Reserves a name.
    void take(const std::string& name) { taken_.insert(name); }

    bool isFree(const std::string& name) const { return !taken_.contains(name); }

    /// The name itself if it is free, else with a number from 2 on.
    /// @param before  separator in front of the number
    std::string free(const std::string& wanted, const char* before = " ") {
        return taken_.insert(wanted).second ? wanted : numbered(wanted, before, 2);
    }

    /// Always with a number: for names of which there will be more.
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
