// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "app/document/view_state.h"
#include "app/render/overlay_scale.h"

namespace toile {

/// What the views draw, as plain buffers ready for upload: made once per flattening, off the GUI
/// thread, then shared and never changed. Overlay, selection, colours and the pieces' places on
/// the sheet are not in the vertices, so that changing them uploads no mesh.

/// Millimetres; positions are relative to Scene::origin.
struct GarmentVertex {
    float position[3];
    float normal[3];  ///< unit, towards the fabric's right side
    float flat[2];    ///< the piece's own flat coordinates: the checkerboard's coordinates
    float values[3];  ///< area change %, angle change degrees, strain %
    float piece;      ///< index into the garment's pieces
};

struct PatternVertex {
    float flat[2];  ///< mm, before the sheet's offset
    float values[3];
    float piece;
};

/// A run of triangles in MeshBuffers::triangles, counted in triangles.
struct TriangleRun {
    std::uint32_t first = 0, count = 0;
};

/// One vertex buffer and three ways to draw it, all pieces one after the other.
template <class Vertex>
struct MeshBuffers {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> triangles;  ///< 3 per triangle
    std::vector<std::uint32_t> edges;      ///< 2 per edge
    std::vector<std::uint32_t> outline;    ///< 2 per boundary edge
};

/// Per piece: where it is, for framing, picking and labels.
struct PieceScene {
    bool flat = false;
    Eigen::AlignedBox3d box;                           ///< 3D, relative to Scene::origin
    Eigen::AlignedBox2d flatBox;                       ///< without offset; empty where not flat
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();  ///< place on the sheet
    Eigen::Vector2d label = Eigen::Vector2d::Zero();   ///< a point well inside, without offset
    TriangleRun garmentRun, patternRun;

    Eigen::AlignedBox2d placedBox() const {
        return flat ? Eigen::AlignedBox2d(flatBox.min() + offset, flatBox.max() + offset)
                    : Eigen::AlignedBox2d();
    }
};

struct Scene {
    /// Middle of the garment: taken off in double precision, so that a garment far from the
    /// coordinate origin keeps its digits in floats.
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    MeshBuffers<GarmentVertex> garment;
    MeshBuffers<PatternVertex> pattern;  ///< pieces that are flat only
    std::vector<PieceScene> pieces;
    std::array<OverlayScale, kOverlayCount> scales;  ///< by Overlay
    Eigen::AlignedBox3d box;                         ///< relative to origin
    Eigen::AlignedBox2d sheetBox;

    const OverlayScale& scale(Overlay overlay) const {
        return scales[static_cast<std::size_t>(overlay)];
    }
};

}  // namespace toile
