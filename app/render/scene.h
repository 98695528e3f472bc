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

struct GarmentLineVertex {
    float position[3];
    float piece;
};

struct PatternLineVertex {
    float flat[2];  ///< mm, before the sheet's offset
    float piece;
    float along;  ///< mm from the line's beginning, for dashes
};

/// A polyline: a run of vertices in LineBuffers::vertices.
struct VertexRun {
    std::uint32_t first = 0, count = 0;
};

/// Where the lines are that a view draws over the cloth.
struct LineRuns {
    /// Per seam of the garment its left and its right side; count 0 where there is none: the right
    /// side of a free edge, and in the pattern a side whose piece is not flat.
    std::vector<std::array<VertexRun, 2>> seams;
    std::vector<VertexRun> designer;  ///< loops of the designer's panels; in the pattern only
};

template <class Vertex>
struct LineBuffers {
    std::vector<Vertex> vertices;
    LineRuns runs;
};

/// Per seam: where it is, for framing. Empty where nothing of it is drawn.
struct SeamScene {
    Eigen::AlignedBox3d box;      ///< both sides, relative to Scene::origin
    Eigen::AlignedBox2d flatBox;  ///< both sides, at their places on the sheet
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
    LineBuffers<GarmentLineVertex> garmentLines;
    LineBuffers<PatternLineVertex> patternLines;
    std::vector<PieceScene> pieces;
    std::vector<SeamScene> seams;                    ///< one per seam of the garment
    std::array<OverlayScale, kOverlayCount> scales;  ///< by Overlay
    Eigen::AlignedBox3d box;                         ///< relative to origin
    Eigen::AlignedBox2d sheetBox;

    const OverlayScale& scale(Overlay overlay) const {
        return scales[static_cast<std::size_t>(overlay)];
    }
};

}  // namespace toile
