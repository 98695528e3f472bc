// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_state.h"

#include <algorithm>
#include <utility>

#include "core/marker/marker_settings.h"
#include "core/project/layer_materials.h"

namespace toile::app {

ClothPlans::ClothPlans() {
    static const auto nothing = std::make_shared<const Plans>();
    plans_ = nothing;
}

ClothPlans::ClothPlans(Plans plans) : plans_(std::make_shared<const Plans>(std::move(plans))) {}

const ClothPlans::Plans& ClothPlans::all() const {
    return *plans_;
}

const MarkerPlan& ClothPlans::of(const std::string& material) const {
    static const MarkerPlan kUnsaid;
    const auto found = plans_->find(material);
    return found == plans_->end() ? kUnsaid : found->second;
}

ClothPlans ClothPlans::with(const std::string& material, MarkerPlan plan) const {
    Plans plans = *plans_;
    if (plan == MarkerPlan{}) {
        plans.erase(material);
    } else {
        plans[material] = std::move(plan);
    }
    return ClothPlans(std::move(plans));
}

bool ClothPlans::operator==(const ClothPlans& other) const {
    return plans_ == other.plans_ || *plans_ == *other.plans_;
}

MaterialList materialsInUse(const DocumentState& state) {
    std::vector<std::string> used;
    for (const auto& [id, said] : state.settings) {
        used.push_back(said.material);
    }
    return toile::materialsInUse(state.materials, used, state.fabric);
}

std::set<PieceId> leftOut(const SettingsById& settings) {
    std::set<PieceId> found;
    for (const auto& [id, said] : settings) {
        if (said.leftOut) {
            found.insert(id);
        }
    }
    return found;
}

namespace {

bool isLeftOutOtherwise(const PieceResult& result, const DocumentState& state) {
    const auto said = state.settings.find(result.piece->id);
    return isLeftOut(result) != (said != state.settings.end() && said->second.leftOut);
}

}  // namespace

bool isFlattened(const Derived& derived, const DocumentState& state) {
    if (!derived.garment || derived.results.size() != derived.garment->pieces.size() ||
        derived.lines != state.lines) {
        return false;
    }
    for (std::size_t i = 0; i < derived.results.size(); ++i) {
        const PieceResult* result = derived.results[i].get();
        if (!result || result->piece != derived.garment->pieces[i] ||
            !(result->options == state.options) || isLeftOutOtherwise(*result, state)) {
            return false;
        }
    }
    return true;
}

bool isLeftOutOtherwise(const Derived& derived, const DocumentState& state) {
    return std::ranges::any_of(derived.results, [&state](const auto& result) {
        return result && isLeftOutOtherwise(*result, state);
    });
}

bool isWarm(const Derived& derived) {
    return std::ranges::any_of(derived.results,
                               [](const auto& result) { return result && isWarm(*result); });
}

}  // namespace toile::app
