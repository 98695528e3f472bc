// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/position_merger.h"

#include <bit>

namespace toile {
namespace {

constexpr std::size_t kFirstSlots = 1024;

std::uint64_t hash(const Eigen::Vector3d& position) {
    std::uint64_t h = 0;
    for (const double coordinate : position) {
        h = (h ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15u;
        h ^= h >> 32;  // the high bits are the well mixed ones, the slot takes the low
    }
    return h;
}

bool sameBits(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    return bits(a.x()) == bits(b.x()) && bits(a.y()) == bits(b.y()) && bits(a.z()) == bits(b.z());
}

}  // namespace

PositionMerger::PositionMerger(std::vector<Eigen::Vector3d>& positions)
    : positions_(positions), slots_(kFirstSlots, -1) {}

int PositionMerger::indexOf(Eigen::Vector3d position, bool& isNew) {
    position.array() += 0.0;  // -0 + 0 is 0, all else stays
    std::size_t slot = slotOf(position);
    isNew = slots_[slot] < 0;
    if (isNew) {
        if (2 * (positions_.size() + 1) > slots_.size()) {
            grow();
            slot = slotOf(position);
        }
        slots_[slot] = static_cast<int>(positions_.size());
        positions_.push_back(position);
    }
    return slots_[slot];
}

std::size_t PositionMerger::slotOf(const Eigen::Vector3d& position) const {
    std::size_t slot = hash(position) & (slots_.size() - 1);
    while (slots_[slot] >= 0 && !sameBits(positions_[slots_[slot]], position)) {
        slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
}

void PositionMerger::grow() {
    slots_.assign(2 * slots_.size(), -1);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        slots_[slotOf(positions_[i])] = static_cast<int>(i);
    }
}

}  // namespace toile
