// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/render/sheet_places.h"
#include "core/project/place_pieces.h"

namespace toile {

/// Where one flattening of a piece lies on the sheet so that it covers another one of it, as well
/// as two shapes can: flat coordinates of two methods have nothing in common. Keeps the motion
/// between the two, which takes a look at every vertex.
class SamePlace {
public:
    /// @param result     flat
    /// @param reference  what the settings are about; may be null or not flat: then the result
    ///                   lies as if they were about itself
    SheetPlace of(const std::shared_ptr<const PieceResult>& result,
                  const std::shared_ptr<const PieceResult>& reference, PieceSettings settings);

private:
    std::shared_ptr<const PieceResult> result_, reference_;
    std::optional<FlatMotion> motion_;
};

}  // namespace toile
