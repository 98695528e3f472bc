// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/export/export_source.h"
#include "core/pattern/cubic_curve.h"

namespace toile {

/// A pattern as panels of edges, one curve each, that are stitched one to one, as in GarmentCode
/// files. Panels are the seam lines of whole pieces; holes and drawn lines are left out.

struct PanelEdge {
    CubicCurve curve{};  ///< mm, in the piece's own coordinates
    double length = 0;   ///< of the curve, mm
};

struct SewnPanel {
    std::string name{};              ///< unique
    std::string label{};             ///< the name of the piece
    std::vector<PanelEdge> edges{};  ///< anti-clockwise round the piece
    /// The motion that brings the flat piece nearest to the garment: turned, then moved, mm.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d shift{0, 0, 0};
};

struct SewnEdges {
    struct Side {
        int panel = 0, edge = 0;
    };
    std::array<Side, 2> sides{};
};

struct SewnPanels {
    std::vector<SewnPanel> panels{};
    std::vector<SewnEdges> stitches{};
};

/// If a curve of one side of a seam ends, the other side is divided at the same share of its
/// length. Joints of the two sides nearer than this coincide, mm.
inline constexpr double kSameJoint = 0.04;

/// @param source  provides the whole pattern (`LaidOutPattern::wholePattern`)
/// Cost: that of `curvesOf` for each segment. Pure.
SewnPanels sewnPanels(const ExportSource& source);

}  // namespace toile
