// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/document/reference.h"
#include "core/garment/fabric.h"
#include "core/project/piece_settings.h"
#include "core/prove/proof_settings.h"
#include "core/toile/pipeline.h"

namespace toile {
struct MarkerPlan;
struct Pattern;
struct Symmetry;
}  // namespace toile

namespace toile::app {

struct Scene;

/// The settings for laying the pieces on cloth, by material (`MarkerPlans`). Copies are cheap, as
/// for all states of the history.
class ClothPlans {
public:
    using Plans = std::map<std::string, MarkerPlan>;

    ClothPlans();
    explicit ClothPlans(Plans plans);

    const Plans& all() const;
    /// Default settings if there are none for the material.
    const MarkerPlan& of(const std::string& material) const;
    ClothPlans with(const std::string& material, MarkerPlan plan) const;

    bool operator==(const ClothPlans& other) const;

private:
    std::shared_ptr<const Plans> plans_;
};

/// The user's decisions: one step of the history changes them, and undo brings them back. Nothing
/// in it is derived; copies are cheap.
struct DocumentState {
    GarmentInputs inputs{};    ///< files, how they are divided and cut, stated ease
    FlattenOptions options{};  ///< how pieces are flattened
    LineSettings lines{};      ///< how their outlines are drawn
    Fabric fabric = fabricPresets().front();
    MaterialList materials{};  ///< other fabrics that pieces are cut from
    SettingsById settings{};
    PieceLabels labels{};
    ReferenceFile reference{};  ///< compared with the pieces
    ClothPlans markers{};       ///< how the pieces are laid on cloth
    ProofPlan proof{};          ///< how the pattern is proved

    bool operator==(const DocumentState&) const = default;
};

/// The results for a state. Immutable and shared; equality compares large parts by pointer.
struct Derived {
    GarmentInputs inputs{};                    ///< inputs of the garment
    std::shared_ptr<const Garment> garment{};  ///< null if nothing is open
    /// One per piece, null if not flattened yet; or empty. May be of older options, or warm, until
    /// newer ones come.
    PieceResults results{};
    std::optional<LineSettings> lines = LineSettings{};  ///< of the results; none: older ones
    /// The symmetry that results are mirrored by; null if they are not.
    std::shared_ptr<const Symmetry> symmetry{};
    /// The flat pieces as a pattern, and the content of the views: of all this; or both null.
    std::shared_ptr<const Pattern> pattern{};
    std::shared_ptr<const Scene> scene{};
    std::size_t bytes = 0;  ///< approximate size of results and scene

    bool operator==(const Derived&) const = default;
};

/// The state's materials that some piece is cut from, and new ones that pieces name.
MaterialList materialsInUse(const DocumentState& state);
/// Pieces that are left out.
std::set<PieceId> leftOut(const SettingsById& settings);
/// True if every piece has the result that the state asks for.
bool isFlattened(const Derived& derived, const DocumentState& state);
/// True if a flat piece should be left out, or the other way round, as far as that is known.
bool isLeftOutOtherwise(const Derived& derived, const DocumentState& state);
/// True if some result is warm, that is, preliminary.
bool isWarm(const Derived& derived);

}  // namespace toile::app
