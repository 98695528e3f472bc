// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/garment/fabric.h"
#include "core/pipeline/pipeline.h"
#include "core/project/piece_labels.h"
#include "core/project/piece_settings.h"

namespace toile {

struct Scene;

/// The open garment and everything a person has made of it: what one step of the history changes
/// and undo brings back. Copies are cheap, since what is large is immutable and shared; equality
/// compares it by pointer.
struct DocumentState {
    std::shared_ptr<const Garment> garment{};  ///< null where nothing is open
    LoadOptions loading{};     ///< how the files were read, divided and cut, and the ease stated
    FlattenOptions options{};  ///< how pieces are to be flattened
    Fabric fabric = fabricPresets().front();
    std::vector<PieceSettings> settings{};  ///< one per piece of the garment
    PieceLabels labels{};                   ///< of these pieces, and of some that may come back

    /// What follows is made of the above. Results may be of older options, or of pieces that are
    /// no more in the garment (`PieceResult::piece`, `options` tell), until new ones come.
    PieceResults results{};  ///< one per piece, null where not flattened yet; or empty
    std::shared_ptr<const Scene> scene{};  ///< what the views draw; may be null
    /// The results were all there, and were let go for their memory: they are to be found again.
    bool letGo = false;

    bool operator==(const DocumentState&) const = default;
};

/// True where every piece has the result that the state's garment and options ask for.
bool isFlattened(const DocumentState& state);

}  // namespace toile
