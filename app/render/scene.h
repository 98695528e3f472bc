// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "app/document/view_state.h"
#include "app/render/colour_map.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/geometry/triangle_tree.h"
#include "core/project/piece_settings.h"

namespace toile::app {

struct Scene;

/// Principal strains at one place, for both views.
struct GlyphVertex {
    float position[3];   ///< mm, relative to Scene::origin
    float flat[2];       ///< mm, the piece's own coordinates
    float flatAlong[2];  ///< direction of the larger stretch on the flat piece, unit
    float along[3];      ///< the same on the garment, unit; and of the smaller stretch
    float across[3];
    float strain[2];  ///< larger and smaller, percent
    float piece;
};

/// Places spread evenly over the flat cloth, in an order in which every beginning of the list is
/// spread evenly too: what is drawn at a scale is one run from the first on.
struct StrainGlyphs {
    std::vector<GlyphVertex> vertices;
    double finest = 1;  ///< mm between neighbours where all are drawn
    /// How many are at least sqrt(2)^i times as far apart; falling.
    std::vector<std::uint32_t> counts;
};

/// The beginning of the list whose neighbours are at least this far apart, and how far.
struct GlyphRange {
    std::uint32_t count = 0;
    double spacing = 1;  ///< mm
};

GlyphRange glyphsAt(const StrainGlyphs& glyphs, double leastSpacing);

/// Of a scene that has its pieces, vertices and triangles. At most some ten thousand places, no
/// more than triangles, and one at least on each flat piece. Cost: linear.
StrainGlyphs makeStrainGlyphs(const Scene& scene);

/// What the views draw, as plain buffers ready for upload: made once per flattening, off the GUI
/// thread, then shared and never changed. Overlay, selection, colours and the pieces' places on
/// the sheet (`SheetPlaces`) are not in it, so that changing them uploads no mesh.

/// Of the cloth, for both views. Millimetres; positions are relative to Scene::origin.
struct ClothVertex {
    float position[3];
    float normal[3];  ///< unit, towards the fabric's right side
    float flat[2];    ///< the piece's own flat coordinates, the checkerboard's too; else 0
    float values[4];  ///< area change %, angle change degrees, largest and least edge strain %
    float metric[3];  ///< E, F, G of the map from flat to worn (core/quality/metric_tensor.h)
    float piece;      ///< index into the garment's pieces
};

/// Where a vertex of any of these kinds that has one lies flat, mm, the piece's own coordinates,
/// and where it is worn, relative to Scene::origin.
template <class Vertex>
Eigen::Vector2d flatPoint(const Vertex& vertex) {
    return Eigen::Map<const Eigen::Vector2f>(vertex.flat).template cast<double>();
}

template <class Vertex>
Eigen::Vector3d wornPoint(const Vertex& vertex) {
    return Eigen::Map<const Eigen::Vector3f>(vertex.position).template cast<double>();
}

/// The same of a triangle alone, as two RGBA texels.
struct FaceValues {
    float values[4];
    float metric[3];
    float flatArea;  ///< mm2, positive
};

/// A run of triangles in MeshIndices::triangles, counted in triangles.
struct TriangleRun {
    std::uint32_t first = 0, count = 0;
};

/// Three ways to draw the vertices, all pieces one after the other.
struct MeshIndices {
    std::vector<std::uint32_t> triangles;  ///< 3 per triangle
    std::vector<std::uint32_t> edges;      ///< 2 per edge
    std::vector<std::uint32_t> outline;    ///< 2 per boundary edge
};

/// What a line says of itself by its colour: an index into the seam palette (`seamPalette`), or
/// one of these.
inline constexpr float kFreeEdgeTint = -1, kNoTint = -2;

/// Of the lines that both views draw over the cloth.
struct LineVertex {
    float position[3];
    float flat[2];  ///< where the piece lies flat, its own coordinates; else 0
    float piece;    ///< of what belongs to none: one past the last
    float along;    ///< mm on the flat piece from the line's beginning, for dashes
    float tint;
};

/// A polyline: a run of vertices in Scene::lineVertices.
struct VertexRun {
    std::uint32_t first = 0, count = 0;
};

/// Where the lines are that a view draws over the cloth.
struct LineRuns {
    /// Per seam of the garment its left and its right side; count 0 where there is none: the right
    /// side of a free edge, and in the pattern a side whose piece is not flat.
    std::vector<std::array<VertexRun, 2>> seams;
    std::vector<VertexRun> reference;  ///< loops of the reference panels; in the pattern only
    std::vector<VertexRun> exact;      ///< outlines as they were solved, where others are drawn
    std::vector<VertexRun> cutting;    ///< round pieces and their allowances; in the pattern only
    std::vector<VertexRun> notches;    ///< strokes; in the pattern only
    std::vector<VertexRun> internal;   ///< internal lines, and in the pattern marks of darts
    std::vector<VertexRun> leftOut;    ///< edges of what was left out of files; on the garment only
    /// Per piece its outline, the first vertex once more at the end; empty of a piece that is no
    /// disk, and in the pattern of one that is not flat.
    std::vector<VertexRun> outlines;
    /// Per piece: which vertices of its outline those of Piece::boundary are, the first once more
    /// at the end; empty where vertex k is vertex k of Piece::boundary.
    std::vector<std::vector<std::uint32_t>> boundaryAt;
};

/// Per seam: where it is, for framing. Empty where nothing of it is drawn.
struct SeamScene {
    Eigen::AlignedBox3d box;  ///< both sides, relative to Scene::origin
    /// Left and right side in the flat coordinates of their pieces; empty where not flat.
    struct Side {
        int piece = -1;
        Eigen::AlignedBox2d flatBox{};
    };
    std::array<Side, 2> sides;
};

/// A motion without stretching: from a flat piece's own coordinates (x, y, 0) into the scene's.
struct SpaceMotion {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< proper: the third column is the normal
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();

    Eigen::Vector3d applied(const Eigen::Vector2d& point) const {
        return offset + turn.leftCols<2>() * point;
    }
};

/// Per piece: where it is, for framing, picking and labels.
struct PieceScene {
    bool flat = false;
    Eigen::AlignedBox3d box;      ///< 3D, relative to Scene::origin
    Eigen::AlignedBox2d flatBox;  ///< in the piece's own coordinates; empty where not flat
    Eigen::Vector2d label = Eigen::Vector2d::Zero();  ///< a point well inside, likewise
    TriangleRun garmentRun, patternRun;
    geometry::TriangleTree<3> garmentTree;  ///< of garmentRun, counted from its first
    geometry::TriangleTree<2> patternTree;
    /// Vertices of the outline where it turns sharply: places in Piece::boundary, ascending.
    std::vector<int> corners;
    SpaceMotion rest;  ///< lays the flat piece where the worn one is, as near as it can be
};

/// What follows from pieces and results alone: edits of allowances, notches and labels share it, so
/// that they upload no mesh and build no tree.
struct SceneCloth {
    /// Middle of the garment: taken off in double precision, so that a garment far from the
    /// coordinate origin keeps its digits in floats.
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::vector<ClothVertex> vertices;  ///< of all pieces, one after the other
    MeshIndices garment, pattern;       ///< in the pattern those of flat pieces only
    std::vector<FaceValues> faces;      ///< one per triangle of `pattern`
    StrainGlyphs glyphs;
    std::vector<PieceScene> pieces;
    /// By Overlay: the span of the garment's values; one for all directions of strain, so that they
    /// can be compared and a turned grain changes none. Where a fabric has limits these come first.
    std::array<OverlayScale, kOverlayCount> scales;
    Eigen::AlignedBox3d box;  ///< relative to origin
    /// What it was made of; it does not keep a closed garment in memory.
    std::vector<std::weak_ptr<const Piece>> madeOf;
    std::vector<std::weak_ptr<const PieceResult>> results;
};

/// The cloth, and the lines that are drawn over it.
struct Scene {
    Scene() : Scene(std::make_shared<const SceneCloth>()) {}
    explicit Scene(std::shared_ptr<const SceneCloth> of) : cloth(std::move(of)) {}

    const std::shared_ptr<const SceneCloth> cloth;
    const Eigen::Vector3d& origin = cloth->origin;
    const std::vector<ClothVertex>& vertices = cloth->vertices;
    const MeshIndices &garment = cloth->garment, &pattern = cloth->pattern;
    const std::vector<FaceValues>& faces = cloth->faces;
    const StrainGlyphs& glyphs = cloth->glyphs;
    const std::vector<PieceScene>& pieces = cloth->pieces;
    const Eigen::AlignedBox3d& box = cloth->box;

    std::vector<LineVertex> lineVertices;
    LineRuns garmentLines, patternLines;
    std::vector<SeamScene> seams;  ///< one per seam of the garment
    /// Per piece: PieceScene::flatBox with its allowances.
    std::vector<Eigen::AlignedBox2d> edgeBoxes;

    const OverlayScale& scale(Overlay overlay) const {
        return cloth->scales[static_cast<std::size_t>(overlay)];
    }
};

/// Null of no scene.
inline const SceneCloth* clothOf(const std::shared_ptr<const Scene>& scene) {
    return scene ? scene->cloth.get() : nullptr;
}

/// Lines of a reference pattern over the flat pieces of a scene. Separate from the scene, since the
/// pieces that they belong to are found later. Shared and never changed.
struct ReferenceLines {
    std::vector<LineVertex> vertices{};
    LineRuns runs{};  ///< `LineRuns::reference` alone
};

/// About what it takes in memory. Cost: none to speak of.
std::size_t bytesOf(const Scene& scene);

/// What the pattern view knows of one piece beyond its shape.
struct SheetPlace {
    Placement placement{};
    double grain = kGrainUpwards;    ///< direction of the warp in the piece's own coordinates
    int colour = 0;                  ///< its number (`pieceColour`)
    std::optional<Fabric> fabric{};  ///< of its material; none: the garment's own
    bool hidden = false;             ///< drawn in neither view, and not there for the pointer

    bool operator==(const SheetPlace&) const = default;
};

/// One per piece of the scene. Shorter lists stand for pieces that lie where they were made.
using SheetPlaces = std::vector<SheetPlace>;

/// @param colours    one per piece, or none if they are not needed
/// @param materials  that pieces may be of; or none where no fabric is asked for
SheetPlaces placesOf(const std::vector<PieceSettings>& settings,
                     const std::vector<int>& colours = {}, const MaterialList& materials = {});

const SheetPlace& placeOf(const SheetPlaces& places, int piece);

/// The smallest upright box around a box of the piece at its place; empty where that is empty.
Eigen::AlignedBox2d placedBox(const Eigen::AlignedBox2d& box, const Placement& placement);

/// Around both sides of a seam at their places; empty where neither is flat.
Eigen::AlignedBox2d placedBox(const SeamScene& seam, const SheetPlaces& places);

/// The pieces that are not hidden; all of them where each is.
std::set<int> seenOf(const std::set<int>& pieces, const SheetPlaces& places);

/// Around all flat pieces of the scene that are seen, at their places.
Eigen::AlignedBox2d sheetBox(const Scene& scene, const SheetPlaces& places);

}  // namespace toile::app
