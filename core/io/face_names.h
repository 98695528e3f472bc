// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace toile {

/// The names of one kind (objects, groups or materials) and which one each face carries. Fills the
/// soup's lists as it promises: both empty until the first name, a name used twice is one entry.
class FaceNames {
public:
    FaceNames(std::vector<std::string>& names, std::vector<int>& perFace)
        : names_(names), perFace_(perFace) {}

    /// The name of all faces to come, as the file has it; an empty one ends the last.
    /// @param faceCount  faces so far
    void change(std::string_view text, int faceCount);

    void addFace() {
        if (!names_.empty()) {
            perFace_.push_back(current_);
        }
    }

private:
    std::vector<std::string>& names_;
    std::vector<int>& perFace_;
    std::unordered_map<std::string, int> index_;
    int current_ = -1;
};

}  // namespace toile
