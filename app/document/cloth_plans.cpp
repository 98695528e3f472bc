// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/cloth_plans.h"

#include <utility>

#include "core/marker/marker_settings.h"

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

}  // namespace toile::app
