// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/export/export_source.h"
#include "core/pattern/cubic_curve.h"

namespace toile {

/// A pattern as panels of edges, one curve each, that are stitched one to one: what GarmentCode's
/// files hold. Panels are the seam lines of whole pieces; holes and what is drawn are left out.

struct PanelEdge {
    CubicCurve curve{};  ///< mm, in the piece's own coordinates
    double length = 0;   ///< of the curve, mm
};

struct SewnPanel {
    std::string name{};              ///< unique
    std::string label{};             ///< as the piece is called
    std::vector<PanelEdge> edges{};  ///< anti-clockwise round the piece
    /// What brings the flat piece nearest to the garment: turned, then moved, mm.
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

/// Where a curve of one side of a seam ends, the other is divided at the same share of its length.
/// Joints of the two sides nearer to each other than this are one, mm.
inline constexpr double kSameJoint = 0.04;

/// @param source  of which the whole pattern is taken (`LaidOutPattern::wholePattern`)
/// Cost: that of `curvesOf` for each segment. Pure.
SewnPanels sewnPanels(const ExportSource& source);

}  // namespace toile
