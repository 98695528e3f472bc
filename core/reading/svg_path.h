// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {

struct SvgContour {
    Points2 points = Points2(0, 2);  ///< two or more; if closed, the first is not repeated
    bool closed = false;             ///< by Z
};

/// The lines of path data (every command of SVG), with curves and arcs as points within 0.005 of
/// them. Stops at the first error, as browsers do. Leaves out contours with coordinates beyond
/// 10 000 km or not finite.
/// @param place  map from the coordinates of the data to the result
/// @param most   remaining number of points; reduced by those added. At 0 nothing is added.
/// Cost: linear. Pure.
std::vector<SvgContour> svgContours(std::string_view data, const Eigen::Affine2d& place,
                                    std::size_t& most);

}  // namespace toile
