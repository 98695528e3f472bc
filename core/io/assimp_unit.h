// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/io/soup.h"

struct aiScene;

namespace toile {

/// The unit of the coordinates that assimp gives for a file with this ending (".fbx", in any case).
struct AssimpUnit {
    std::optional<StatedUnit> stated;  ///< none where neither format nor file says it
    double scale = 1;                  ///< factor from assimp's coordinates to that unit
};

/// Cost: constant. Pure.
AssimpUnit unitOf(const aiScene& scene, std::string_view ending);

}  // namespace toile
