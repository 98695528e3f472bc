// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/wording.h"
#include "core/prepare/layers.h"
#include "core/prepare/shell.h"

namespace toile {

/// The detected kind of a file, with its evidence.
struct Recognition {
    FileKind kind = FileKind::Sheet;
    Wording evidence{};            ///< for display; empty for plain sheets
    std::optional<Shell> shell{};  ///< if there are two surfaces; a Shell only if rims join them
    std::optional<Layers> layers{};
};

/// Detects the contents of a file from its shape alone. In doubt the result is a sheet. Coinciding
/// vertices must be merged before, because a soup cannot be distinguished from sheets here.
/// @param progress  if cancelled, the result is a sheet
/// Cost: those of `findShell` and `findLayers`. Pure.
Recognition recognise(const FileSurface& surface, const Progress& progress);

}  // namespace toile
