// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

namespace toile {
struct MarkerPlan;
}  // namespace toile

namespace toile::app {

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

}  // namespace toile::app
