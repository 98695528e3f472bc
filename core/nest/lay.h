// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "core/nest/problem.h"

// For the sources of this folder only.
namespace toile::nest {

/// All copies placed inside a strip of some length, overlaps allowed, and the loss of each pair of
/// copies, or of a copy and an obstacle. Weights emphasise pairs in the search for better places.
class Lay {
public:
    /// The problem must outlive this object.
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
    /// Sum over the pairs that collide, without weights, plus the copies that are too long for the
    /// strip in their rotation; exactly 0 if there are none.
    double loss() const;
    double weightedLossOf(std::size_t copy) const;
    /// The end of the last copy.
    double usedLength() const;

    /// The sum of weighted losses of the copy with this shape at (x, y); stops early, with a
    /// partial sum, once that reaches `enough`.
    double lossAt(std::size_t copy, const Shape& shape, double x, double y,
                  double enough = std::numeric_limits<double>::infinity()) const;
    void place(std::size_t copy, const Pose& pose);
    void placeAll(const std::vector<Pose>& poses, double length);

    /// Moves the pose to the closest place that the copy's rules allow; false if there is none.
    bool moveInside(std::size_t copy, const Shape& shape, Pose& pose) const;
    const Shape& shapeOf(std::size_t copy, const Pose& pose, Shape& own) const {
        return nest::shapeOf(problem_->itemOf(copy), pose, own);
    }

    void resetWeights();
    /// Weights of colliding pairs grow in proportion to their loss, the others decay ([GVW25]).
    void raiseWeights();

private:
    /// Number of copies and obstacles.
    std::size_t all() const { return poses_.size(); }
    void setLoss(std::size_t a, std::size_t b, double loss);
    /// Loss of a copy with this shape at (x, y) with a copy or obstacle; 0: no collision.
    double lossWith(std::size_t copy, const Shape& shape, double x, double y,
                    std::size_t other) const;
    void setPose(std::size_t copy, const Pose& pose);
    void setBox(std::size_t k);
    void updateLosses(std::size_t copy);

    const Problem* problem_;
    double length_;
    std::vector<Pose> poses_;  // of obstacles: at the origin
    std::vector<Shape> owned_;
    std::vector<const Shape*> shapes_;
    std::vector<double> left_, bottom_, right_, top_;  ///< of all boxes
    std::vector<double> excess_;                       ///< of copies too large for the strip
    /// Of each copy and obstacle: pairs with a loss, or with a weight above 1, by the other.
    struct Pair {
        std::size_t other;
        double loss, weight;
    };
    std::vector<std::vector<Pair>> pairs_;
};

}  // namespace toile::nest
