// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "core/nest/problem.h"

// For the sources of this folder only.
namespace toile::nest {

/// All copies placed inside a strip that ends at some length, overlaps allowed, and what each pair
/// of them, or of a copy and an obstacle, loses by it. Weights make a pair matter more to those who
/// look for better places.
class Lay {
public:
    /// The problem must outlive it.
    Lay(const Problem& problem, const std::vector<Pose>& poses, double length);
    Lay(const Lay&) = delete;
    Lay& operator=(const Lay&) = delete;

    const Problem& problem() const { return *problem_; }
    std::vector<Pose> poses() const {
        return {poses_.begin(), poses_.begin() + static_cast<std::ptrdiff_t>(count())};
    }
    const Pose& pose(std::size_t copy) const { return poses_[copy]; }
    double length() const { return length_; }
    std::size_t count() const { return problem_->copies.size(); }
    const Shape& shape(std::size_t copy) const { return *shapes_[copy]; }
    /// Sum over the pairs that collide, without weights, and the copies that are longer than the
    /// strip as they are turned; exactly 0 where there are none.
    double loss() const;
    double weightedLossOf(std::size_t copy) const;
    /// Where the last copy ends.
    double usedLength() const;

    /// The sum of weighted losses that the copy would have with this shape at (x, y); stops, with
    /// what it has, as soon as that is `enough`.
    double lossAt(std::size_t copy, const Shape& shape, double x, double y,
                  double enough = std::numeric_limits<double>::infinity()) const;
    void place(std::size_t copy, const Pose& pose);
    void placeAll(const std::vector<Pose>& poses, double length);

    /// The pose moved to the nearest place that the copy's rules allow; false where there is none.
    bool moveInside(std::size_t copy, const Shape& shape, Pose& pose) const;
    const Shape& shapeOf(std::size_t copy, const Pose& pose, Shape& own) const {
        return nest::shapeOf(problem_->itemOf(copy), pose, own);
    }

    void resetWeights();
    /// Pairs that collide grow in proportion to their loss, the others fade ([GVW25]).
    void raiseWeights();

private:
    /// Copies, then obstacles.
    std::size_t all() const { return poses_.size(); }
    double& lossOf(std::size_t a, std::size_t b) { return losses_[a * all() + b]; }
    /// Of a copy with this shape at (x, y) and another one or an obstacle; 0: they do not collide.
    double lossWith(std::size_t copy, const Shape& shape, double x, double y,
                    std::size_t other) const;
    void setPose(std::size_t copy, const Pose& pose);
    void setBox(std::size_t k);
    void updateLosses(std::size_t copy);

    const Problem* problem_;
    double length_;
    std::vector<Pose> poses_;  // of obstacles at the origin
    std::vector<Shape> owned_;
    std::vector<const Shape*> shapes_;
    std::vector<double> left_, bottom_, right_, top_;  ///< of all boxes
    std::vector<double> excess_;                       ///< of copies that do not fit as they lie
    std::vector<double> losses_, weights_;             ///< of pairs, symmetric
};

}  // namespace toile::nest
