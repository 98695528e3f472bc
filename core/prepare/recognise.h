// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/wording.h"
#include "core/prepare/layers.h"
#include "core/prepare/shell.h"

namespace toile {

/// What a file was taken for, and what it was seen by.
struct Recognition {
    FileKind kind = FileKind::Sheet;
    Wording evidence{};            ///< for a person; empty of plain sheets
    std::optional<Shell> shell{};  ///< where there are two surfaces; a Shell only if rims join them
    std::optional<Layers> layers{};
};

/// What a file holds, by its shape alone. Whatever is in doubt is a sheet. Vertices that lie on
/// each other are to be joined before: a soup cannot be told from sheets here.
/// @param progress  cancelled, anything is a sheet
/// Cost: those of `findShell` and `findLayers`. Pure.
Recognition recognise(const FileSurface& surface, const Progress& progress);

}  // namespace toile
