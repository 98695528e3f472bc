// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/formats/pattern_file.h"
#include "core/pattern/curve_fit.h"

namespace toile {

/// A pattern in GarmentCode's JSON (`*.specification.json`): flat panels made of edges, the
/// stitches between edges, and the placement of panels in space.

struct GarmentCodeEdge {
    std::array<int, 2> vertices{};     ///< start and end, indices into the panel
    std::vector<CubicCurve> curves{};  ///< mm, in order; a straight edge has one
    double length = 0;                 ///< mm
};

struct GarmentCodePanel {
    std::string name{}, label{};
    std::vector<GarmentCodeEdge> edges{};  ///< closed loop in order, either winding
    Eigen::Vector3d translation{0, 0, 0};  ///< mm
    Eigen::Vector3d rotation{0, 0, 0};     ///< degrees, about x, then y, then z
};

struct GarmentCodeStitch {
    struct Side {
        int panel = 0, edge = 0;
    };
    std::array<Side, 2> sides{};
};

struct GarmentCode {
    double unit = 10;  ///< mm
    Wording unitReason{};
    bool unitInDoubt = false;
    std::vector<GarmentCodePanel> panels{};  ///< in the file's order of panels
    std::vector<GarmentCodeStitch> stitches{};
    std::vector<Wording> notes{};
};

/// Edges are straight or have a `curvature`: a quadratic or cubic curve with control points
/// relative to the edge, a circular arc by its radius, or, in the older form, two numbers for the
/// control point of a quadratic curve.
/// @param stated  the unit if the user has set it; else `units_in_meter`
/// Errors: MalformedFile with the place in the file. Cost: linear. Pure.
Result<GarmentCode> readGarmentCode(std::string_view bytes,
                                    std::optional<FileUnit> stated = std::nullopt);

/// Closed line through points on its edges, mm.
Points2 outlineOf(const GarmentCodePanel& panel);

/// Converts panels to pieces; their outlines are seam lines.
PatternFile patternOf(const GarmentCode& code);

}  // namespace toile
