// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace toile {

/// Finds equal positions again: for files that repeat a position with every triangle. Equal means
/// the same bits, with -0 taken as 0. Cost: constant per position on average.
class PositionMerger {
public:
    /// Positions are appended to `positions`, in order of first appearance.
    explicit PositionMerger(std::vector<Eigen::Vector3d>& positions);

    /// Index of the position; `isNew` tells whether it is here for the first time.
    int indexOf(Eigen::Vector3d position, bool& isNew);

private:
    std::size_t slotOf(const Eigen::Vector3d& position) const;
    void grow();

    std::vector<Eigen::Vector3d>& positions_;
    std::vector<int> slots_;  ///< open addressing; position index or -1; a power of two
};

}  // namespace toile
