// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/reference_fit.h"

#include <cmath>

namespace toile {
namespace {

/// The best rotation in the plane has a closed form.
ReferenceFit fitRotated(const Points2& flat, const Points2& reference, bool mirrored) {
    const Eigen::Matrix2d H = flat.transpose() * reference;
    const double angle = std::atan2(H(0, 1) - H(1, 0), H(0, 0) + H(1, 1));
    Eigen::Matrix2d R;
    R << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
    const Eigen::VectorXd distance = (flat * R - reference).rowwise().norm();
    return {std::sqrt(distance.squaredNorm() / static_cast<double>(distance.size())),
            distance.maxCoeff(), mirrored};
}

}  // namespace

ReferenceFit fitToReference(const Points2& flat, const Points2& reference) {
    const Points2 from = flat.rowwise() - flat.colwise().mean();
    const Points2 to = reference.rowwise() - reference.colwise().mean();
    Points2 reflected = from;
    reflected.col(0) *= -1;
    const ReferenceFit turned = fitRotated(from, to, false);
    const ReferenceFit mirrored = fitRotated(reflected, to, true);
    return mirrored.rms < turned.rms ? mirrored : turned;
}

}  // namespace toile
