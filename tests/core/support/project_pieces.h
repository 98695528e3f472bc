// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "core/project/project.h"

namespace toile::test {

/// What a project says of the piece of this name; added where it says nothing yet.
inline PieceSettings& said(Project& project, const std::string& name) {
    const auto found = std::ranges::find(project.pieces, name, &ProjectPiece::name);
    if (found != project.pieces.end()) {
        return found->settings;
    }
    project.pieces.push_back({{}, name, {}});
    return project.pieces.back().settings;
}

}  // namespace toile::test
