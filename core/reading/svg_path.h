// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {

struct SvgContour {
    Points2 points = Points2(0, 2);  ///< two or more; where closed, the first is not repeated
    bool closed = false;             ///< by Z
};

/// The lines of path data (every command of SVG), curves and arcs as points within 0.005 of them.
/// Ends where the data are wrong, as a browser does. Contours that leave the plane's middle 10 000
/// km, or hold what is no number, are left out.
/// @param place  from the data's numbers to where they belong
/// @param most   points that may be made still; reduced by those that are. At 0 nothing is added.
/// Cost: linear. Pure.
std::vector<SvgContour> svgContours(std::string_view data, const Eigen::Affine2d& place,
                                    std::size_t& most);

}  // namespace toile
