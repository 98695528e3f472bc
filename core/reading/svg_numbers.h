// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Geometry>

namespace toile {

/// Takes numbers and letters off one of SVG's lists, in which blanks and commas say nothing.
class SvgNumbers {
public:
    explicit SvgNumbers(std::string_view text) : rest_(text) {}

    /// None where something else comes next, or what no double can hold.
    std::optional<double> number();
    /// Two numbers; none where one is missing.
    std::optional<Eigen::Vector2d> pair();
    /// 0 or 1, which a number may follow at once.
    std::optional<bool> flag();
    /// A letter; none where something else comes next.
    std::optional<char> letter();
    /// Letters up to a bracket, and the list within the brackets; none where there is none.
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

/// The map of a transform attribute; what is unknown or incomplete in it changes nothing.
Eigen::Affine2d svgTransform(std::string_view list);

/// A length in millimetres, a pixel being 1/96 inch; none of parts of something else ("50%", "em").
std::optional<double> svgLength(std::string_view text);

}  // namespace toile
