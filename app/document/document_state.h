// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "app/document/cloth_plans.h"
#include "app/document/reference.h"
#include "core/garment/fabric.h"
#include "core/project/piece_settings.h"
#include "core/prove/proof_settings.h"
#include "core/toile/pipeline.h"

namespace toile {
struct Pattern;
struct Symmetry;
}  // namespace toile

namespace toile::app {

struct Scene;

/// What a person has decided: what one step of the history changes and undo brings back. Nothing
/// in it is worked out; copies are cheap.
struct DocumentState {
    GarmentInputs inputs{};    ///< files, how they are divided and cut, the ease stated
    FlattenOptions options{};  ///< how pieces are to be flattened
    LineSettings lines{};      ///< and how their outlines are drawn
    Fabric fabric = fabricPresets().front();
    MaterialList materials{};  ///< of the pieces that are cut from another fabric
    SettingsById settings{};
    PieceLabels labels{};
    ReferenceFile reference{};  ///< that the pieces are compared with
    ClothPlans markers{};       ///< how the pieces are laid on cloth
    ProofPlan proof{};          ///< and how the pattern is proved

    bool operator==(const DocumentState&) const = default;
};

/// What follows from a state. Immutable and shared; equality compares what is large by pointer.
struct Derived {
    GarmentInputs inputs{};                    ///< what the garment was made of
    std::shared_ptr<const Garment> garment{};  ///< null where nothing is open
    /// One per piece, null where not flattened yet; or empty. May be of older options, or warm,
    /// until others come.
    PieceResults results{};
    std::optional<LineSettings> lines = LineSettings{};  ///< that results are of; none: of older
    /// What results are mirrored by; null where they are not.
    std::shared_ptr<const Symmetry> symmetry{};
    /// What is flat, as pieces of cloth, and what the views draw: of all this; or null, both.
    std::shared_ptr<const Pattern> pattern{};
    std::shared_ptr<const Scene> scene{};
    std::size_t bytes = 0;  ///< about what results and scene take

    bool operator==(const Derived&) const = default;
};

/// The state's materials, with all that its pieces are cut from, and without those that nothing is.
MaterialList materialsInUse(const DocumentState& state);
/// Pieces that are left out.
std::set<PieceId> leftOut(const SettingsById& settings);
/// True where every piece has the result that the state asks for.
bool isFlattened(const Derived& derived, const DocumentState& state);
/// True where some piece is flat that is left out, or the other way round, as far as that is known.
bool isLeftOutOtherwise(const Derived& derived, const DocumentState& state);
/// True where some result is warm: another is to take its place.
bool isWarm(const Derived& derived);

}  // namespace toile::app
