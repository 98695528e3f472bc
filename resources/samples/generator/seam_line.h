// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "curves.h"

namespace toile::samples {

/// A seam, hem or opening edge, sampled once. The pieces on both sides of a seam take their
/// outline points from the same SeamLine, so that they coincide to the last digit.
struct SeamLine {
    std::vector<double> parameters;  ///< curve parameter of each point, from 0 to 1
    std::vector<Vec3> points;        ///< evenly spaced along the curve
};

/// Samples `curve` evenly by length, with spacing as near to `spacing` mm as a whole number of
/// steps allows.
SeamLine sampleSeam(const SpaceCurve& curve, double spacing);

/// The points of seams that follow each other, each with the end it starts from; joints once.
struct SeamRun {
    const SeamLine* seam = nullptr;
    bool reversed = false;
};

std::vector<Vec3> joinSeams(const std::vector<SeamRun>& runs);

}  // namespace toile::samples
