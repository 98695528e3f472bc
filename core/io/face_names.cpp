// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/face_names.h"

#include <utility>

#include "core/base/characters.h"

namespace toile {

void FaceNames::change(std::string_view text, int faceCount) {
    if (text.empty()) {
        current_ = -1;
        return;
    }
    if (names_.empty()) {
        perFace_.assign(static_cast<std::size_t>(faceCount), -1);
    }
    std::string name = readableName(text);
    const auto [found, isNew] = index_.try_emplace(name, static_cast<int>(names_.size()));
    if (isNew) {
        names_.push_back(std::move(name));
    }
    current_ = found->second;
}

}  // namespace toile
