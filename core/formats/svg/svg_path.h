// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Reads numbers and letters from one of SVG's lists; blanks and commas are skipped.
class SvgNumbers {
public:
    explicit SvgNumbers(std::string_view text) : rest_(text) {}

    /// None if something else comes next, or a number out of range.
    std::optional<double> number();
    /// Two numbers; none if one is missing.
    std::optional<Eigen::Vector2d> pair();
    /// 0 or 1; a number may follow without a separator.
    std::optional<bool> flag();
    /// A letter; none if something else comes next.
    std::optional<char> letter();
    /// Letters up to a bracket, and the list within the brackets; none if there is no such call.
    struct Call;
    std::optional<Call> call();

    std::string_view rest() const { return rest_; }

private:
    void skipBlanks();

    std::string_view rest_;
};

struct SvgNumbers::Call {
    std::string_view name, list;
};

/// The map of a transform attribute; ignores unknown or incomplete parts.
Eigen::Affine2d svgTransform(std::string_view list);

/// A length in millimetres, at 96 pixels an inch; none for relative units ("50%", "em").
std::optional<double> svgLength(std::string_view text);

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
