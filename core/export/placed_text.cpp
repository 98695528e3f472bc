// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/placed_text.h"

#include <utility>

#include <Eigen/Geometry>

#include "core/export/text_outlines.h"
#include "core/pattern/label.h"

namespace toile {

std::vector<std::vector<CubicCurve>> placedOutlines(const DrawnText& text) {
    std::vector<std::vector<CubicCurve>> all;
    const Eigen::Rotation2Dd turn(text.angle);
    double baseline = -0.5 * text.height;  // capitals are centred on the line's middle
    for (const std::string& line : text.lines) {
        TextOutlines outlines = textOutlines(line, text.height);
        const Eigen::Vector2d start(-0.5 * outlines.width, baseline);
        for (std::vector<CubicCurve>& contour : outlines.contours) {
            for (CubicCurve& curve : contour) {
                for (Eigen::Vector2d* point :
                     {&curve.start, &curve.startHandle, &curve.endHandle, &curve.end}) {
                    *point = text.position + turn * (start + *point);
                }
            }
            all.push_back(std::move(contour));
        }
        baseline -= kLineSpacing * text.height;
    }
    return all;
}

}  // namespace toile
