// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

namespace toile {
struct MarkerPlan;
}  // namespace toile

namespace toile::app {

/// What a person has said of laying the pieces on cloth, by material (`MarkerPlans`). A value that
/// costs nothing to copy, as states of the history are.
class ClothPlans {
public:
    using Plans = std::map<std::string, MarkerPlan>;

    ClothPlans();
    explicit ClothPlans(Plans plans);

    const Plans& all() const;
    /// As nobody has said anything where nothing is said of the material.
    const MarkerPlan& of(const std::string& material) const;
    ClothPlans with(const std::string& material, MarkerPlan plan) const;

    bool operator==(const ClothPlans& other) const;

private:
    std::shared_ptr<const Plans> plans_;
};

}  // namespace toile::app
