// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/reference_fit.h"

#include <cmath>

namespace toile {
namespace {

/// The motion that brings the reference to the flat piece: reference -> turn, about the means.
struct Motion {
    Eigen::Matrix2d turn;  ///< acts on rows from the right; with a reflection where mirrored
    ReferenceFit fit;
};

/// The best rotation in the plane has a closed form. Both point sets about their means.
Motion turnTo(const Points2& flat, const Points2& reference, bool mirrored) {
    Eigen::Matrix2d reflection = Eigen::Matrix2d::Identity();
    reflection(0, 0) = mirrored ? -1 : 1;
    const Eigen::Matrix2d H = (reference * reflection).transpose() * flat;
    const double angle = std::atan2(H(0, 1) - H(1, 0), H(0, 0) + H(1, 1));
    Eigen::Matrix2d R;
    R << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
    const Eigen::Matrix2d turn = reflection * R;
    const Eigen::VectorXd distance = (reference * turn - flat).rowwise().norm();
    return {turn,
            {std::sqrt(distance.squaredNorm() / static_cast<double>(distance.size())),
             distance.maxCoeff(), mirrored}};
}

Motion bestMotion(const Points2& flat, const Points2& reference) {
    const Points2 to = flat.rowwise() - flat.colwise().mean();
    const Points2 from = reference.rowwise() - reference.colwise().mean();
    const Motion turned = turnTo(to, from, false);
    const Motion mirrored = turnTo(to, from, true);
    return mirrored.fit.rms < turned.fit.rms ? mirrored : turned;
}

}  // namespace

ReferenceFit fitToReference(const Points2& flat, const Points2& reference) {
    return bestMotion(flat, reference).fit;
}

Points2 placedReference(const Points2& flat, const Points2& reference) {
    const Motion motion = bestMotion(flat, reference);
    return ((reference.rowwise() - reference.colwise().mean()) * motion.turn).rowwise() +
           flat.colwise().mean();
}

}  // namespace toile
