// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document_state.h"
#include "app/document/sewn_pattern.h"
#include "core/prove/proof.h"

namespace toile::app {

struct SewnCloth;

/// How a document's pattern is proved, as a person has said it.
struct ProofPlan {
    SewnPattern sewn = SewnPattern::Own;
    std::filesystem::path body{};  ///< what it is worn on, a mesh; empty: the design's own surface
    ProofSettings settings{};

    bool operator==(const ProofPlan&) const = default;
};

/// All of a document that a proof depends on. Places on the sheet, names, and what is drawn beside
/// the seam line (allowances, notches, lines inside, texts) do not matter to it. Compares what is
/// large by pointer.
struct ProofGround {
    struct Cloth {
        double grain = 0;  ///< radians
        std::string material{};
        bool leftOut = false;

        bool operator==(const Cloth&) const = default;
    };

    std::shared_ptr<const Garment> garment{};
    PieceResults results{};
    LoadOptions loading{};  ///< for the ease
    LineSettings lines{};   ///< without what does not matter
    Fabric fabric{};
    MaterialList materials{};
    std::vector<Cloth> pieces{};
    std::shared_ptr<const PatternFile> reference{};  ///< where that is what is sewn

    bool operator==(const ProofGround&) const = default;
};

/// @param settings  one per piece of the garment shown
ProofGround proofGround(const Derived& derived, const DocumentState& state,
                        const std::vector<PieceSettings>& settings, SewnPattern sewn);

/// A pattern sewn back together, or on its way there, as it is shown. Immutable.
struct ShownProof {
    ProofGround ground{};
    ProofPlan plan{};                      ///< by which it was sewn
    std::shared_ptr<const Proof> proof{};  ///< null: the cloth is still on its way
    /// Where the cloth lies; of `ground`'s garment. May be null.
    std::shared_ptr<const SewnCloth> cloth{};
};

}  // namespace toile::app
