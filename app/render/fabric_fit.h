// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/render/scene.h"
#include "app/render/sheet_places.h"
#include "core/garment/fabric.h"

namespace toile {

/// How much of a garment a fabric cannot do, as parts of its flat area. What counts as beyond is
/// every triangle that the overlays' histograms of warp, weft and bias count so.
struct FabricFit {
    /// The piece of which the largest part is strained beyond the fabric, in any direction.
    struct WorstPiece {
        int piece = -1;
        double share = 0;  ///< of its own flat area

        bool operator==(const WorstPiece&) const = default;
    };

    double warp = 0, weft = 0, bias = 0;
    double any = 0;                     ///< beyond in one of the directions at least
    std::optional<WorstPiece> worst{};  ///< none where nothing is beyond

    bool operator==(const FabricFit&) const = default;
};

/// All that the fit depends on.
struct FabricQuestion {
    std::shared_ptr<const Scene> scene{};  ///< may be null
    SheetPlaces places{};                  ///< for the grain
    Fabric fabric{};
};

/// True where the answer is the same: places on the sheet do not matter, grain does.
bool isSameQuestion(const FabricQuestion& one, const FabricQuestion& other);

/// None where there is no flat cloth. Pure, thread-safe. Cost: linear, some tenths of a second at a
/// million triangles.
std::optional<FabricFit> fabricFit(const FabricQuestion& question);

}  // namespace toile
