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

/// How the state's pattern is proved: as the settings ask, but its own pattern is sewn if the
/// reference pattern is not open.
ProofPlan proofPlanOf(const DocumentState& state);

/// The parts of a document that a proof depends on. Positions on the sheet, names, allowances,
/// notches, internal lines and texts do not belong to it. Flat pieces are
/// compared by their points, so that a proof of settled ones stays valid when they replace warm
/// ones. Other large parts are compared by pointer.
struct ProofGround {
    struct Cloth {
        std::uint64_t flat = 0;  ///< `PieceResult::fingerprint`; 0: not flat
        double grain = 0;        ///< radians
        std::string material{};
        bool leftOut = false;

        bool operator==(const Cloth&) const = default;
    };

    std::shared_ptr<const Garment> garment{};
    FlattenOptions options{};
    LoadOptions loading{};  ///< for the ease
    LineSettings lines{};   ///< only what cloth depends on
    Fabric fabric{};
    MaterialList materials{};
    std::vector<Cloth> pieces{};
    std::shared_ptr<const PatternFile> reference{};  ///< if that is sewn

    bool operator==(const ProofGround&) const = default;
};

/// @param settings  one per piece of the shown garment
ProofGround proofGround(const Derived& derived, const DocumentState& state,
                        const std::vector<PieceSettings>& settings, SewnPattern sewn);

/// The same ground with these flat pieces. @param results  one per piece; may be null
ProofGround withFlat(ProofGround ground, const PieceResults& results);

/// A pattern sewn back together, or being sewn, as it is shown. Immutable.
struct ShownProof {
    ProofGround ground{};
    ProofPlan plan{};                      ///< settings that it was sewn with
    std::shared_ptr<const Proof> proof{};  ///< null: still being sewn
    /// The cloth, of the garment of `ground`. May be null.
    std::shared_ptr<const SewnCloth> cloth{};
};

}  // namespace toile::app
