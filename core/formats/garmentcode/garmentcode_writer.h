// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/formats/export_source.h"
#include "core/formats/read_back.h"
#include "core/pattern/curve_fit.h"

namespace toile {

/// The two parts of a curve, before and after a parameter.
/// @param t  in (0, 1)
std::array<CubicCurve, 2> dividedAt(const CubicCurve& curve, double t);

/// Divides a chain of curves at these arc lengths; every part is a curve of its own.
/// @param places  mm, ascending; those within `near` of a joint divide nothing
/// Cost: about twenty length computations per place. Pure.
std::vector<CubicCurve> dividedChain(const std::vector<CubicCurve>& chain,
                                     const std::vector<double>& places, double near);

/// Arc lengths of the inner joints of a chain, mm, ascending: one fewer than curves.
std::vector<double> jointsOf(const std::vector<CubicCurve>& chain);

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

/// GarmentCode's JSON: centimetres, each edge straight or one cubic curve relative to its chord,
/// stitches edge to edge, panels at their place in the garment (turned about x, then y, then z).
/// Keys in the order of GarmentCode's own files. Cost: linear. Pure.
std::string writeGarmentCode(const SewnPanels& panels);

/// Reads such a file and compares it with its pattern: each panel is there once, its vertices are
/// on the piece's outline, edges are as long as the outline between them, and stitches together
/// cover each seam on both sides.
/// @param pattern  whole  Errors: NotReadBack, with the panel and the figure. Pure.
Result<ReadBack> readBackGarmentCode(const std::string& bytes, const Pattern& pattern);

}  // namespace toile
