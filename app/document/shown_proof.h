// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/document_state.h"
#include "core/prove/proof.h"

namespace toile::app {

struct SewnCloth;

/// How the state's pattern is to be proved: as has been said, but for a reference pattern that is
/// not open, in whose place its own is sewn.
ProofPlan proofPlanOf(const DocumentState& state);

/// All of a document that a proof depends on. Places on the sheet, names, and what is drawn beside
/// the seam line (allowances, notches, lines inside, texts) do not matter to it. Flat pieces are
/// the same where their points are, so that a proof of settled ones is of the pattern once they
/// have taken the place of warm ones. Compares what else is large by pointer.
struct ProofGround {
    struct Cloth {
        std::uint64_t flat = 0;  ///< `PieceResult::fingerprint`; 0: it is not flat
        double grain = 0;        ///< radians
        std::string material{};
        bool leftOut = false;

        bool operator==(const Cloth&) const = default;
    };

    std::shared_ptr<const Garment> garment{};
    FlattenOptions options{};
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

/// The same ground with these flat pieces. @param results  one per piece; may be null
ProofGround withFlat(ProofGround ground, const PieceResults& results);

/// A pattern sewn back together, or on its way there, as it is shown. Immutable.
struct ShownProof {
    ProofGround ground{};
    ProofPlan plan{};                      ///< by which it was sewn
    std::shared_ptr<const Proof> proof{};  ///< null: the cloth is still on its way
    /// Where the cloth lies; of `ground`'s garment. May be null.
    std::shared_ptr<const SewnCloth> cloth{};
};

}  // namespace toile::app
