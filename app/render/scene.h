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

/// Principal strains at one place.
struct GlyphVertex {
    float position[3];   ///< mm, relative to Scene::origin
    float flat[2];       ///< mm, the piece's own coordinates
    float flatAlong[2];  ///< direction of the larger stretch on the flat piece, unit
    float along[3];      ///< both directions on the garment, unit; first the larger stretch
    float across[3];
    float strain[2];  ///< larger and smaller, percent
    float piece;
};

/// Places spread evenly over the flat cloth. Every prefix of the list is also spread evenly, so
/// that each scale draws one run from the start.
struct StrainGlyphs {
    std::vector<GlyphVertex> vertices;
    double finest = 1;  ///< mm between neighbours if all are drawn
    /// Number of places at a spacing of at least sqrt(2)^i times `finest`; decreasing.
    std::vector<std::uint32_t> counts;
};

/// The longest prefix with at least this spacing, and its actual spacing.
struct GlyphRange {
    std::uint32_t count = 0;
    double spacing = 1;  ///< mm
};

GlyphRange glyphsAt(const StrainGlyphs& glyphs, double leastSpacing);

/// Precondition: the scene has its pieces, vertices and triangles. Makes at most some ten thousand
/// places, no more than triangles, and at least one per flat piece. Cost: linear.
StrainGlyphs makeStrainGlyphs(const Scene& scene);

/// The contents of the views as plain buffers for upload. Made once per flattening, off the GUI
/// thread, then shared and immutable. Overlay, selection, colours and the pieces' places on the
/// sheet (`SheetPlaces`) are kept elsewhere, so that changing them uploads no mesh.

/// A vertex of the cloth. Millimetres; positions are relative to Scene::origin.
struct ClothVertex {
    float position[3];
    float normal[3];  ///< unit, towards the fabric's right side
    float flat[2];    ///< flat coordinates of the piece and the checkerboard; 0 if not flat
    float values[4];  ///< area change %, angle change degrees, largest and least edge strain %
    float metric[3];  ///< E, F, G of the map from flat to worn (core/quality/metric_tensor.h)
    float piece;      ///< index into the garment's pieces
};

/// Positions of a vertex of any of these kinds: flat, mm, in the piece's own coordinates, and worn,
/// relative to Scene::origin.
template <class Vertex>
Eigen::Vector2d flatPoint(const Vertex& vertex) {
    return Eigen::Map<const Eigen::Vector2f>(vertex.flat).template cast<double>();
}

template <class Vertex>
Eigen::Vector3d wornPoint(const Vertex& vertex) {
    return Eigen::Map<const Eigen::Vector3f>(vertex.position).template cast<double>();
}

/// Values of a single triangle, as two RGBA texels.
struct FaceValues {
    float values[4];
    float metric[3];
    float flatArea;  ///< mm2, positive
};

/// A range in MeshIndices::triangles, counted in triangles.
struct TriangleRun {
    std::uint32_t first = 0, count = 0;
};

/// Index lists for three ways to draw the vertices; pieces are concatenated.
struct MeshIndices {
    std::vector<std::uint32_t> triangles;  ///< 3 per triangle
    std::vector<std::uint32_t> edges;      ///< 2 per edge
    std::vector<std::uint32_t> outline;    ///< 2 per boundary edge
};

/// The tint of a line: an index into the seam palette (`seamPalette`), or one of these.
inline constexpr float kFreeEdgeTint = -1, kNoTint = -2;

/// A vertex of lines over the cloth.
struct LineVertex {
    float position[3];
    float flat[2];  ///< flat position in the piece's own coordinates; 0 if not flat
    float piece;    ///< index; one past the last for lines without a piece
    float along;    ///< mm on the flat piece from the line's start, for dashes
    float tint;
};

/// A polyline: a range in Scene::lineVertices.
struct VertexRun {
    std::uint32_t first = 0, count = 0;
};

/// The lines that a view draws over the cloth.
struct LineRuns {
    /// Left and right side of each seam. The count is 0 for the right side of a free edge and, in
    /// the pattern, for a side whose piece is not flat.
    std::vector<std::array<VertexRun, 2>> seams;
    std::vector<VertexRun> reference;  ///< loops of the reference panels; in the pattern only
    std::vector<VertexRun> exact;      ///< solved outlines, if others are drawn
    std::vector<VertexRun> cutting;    ///< cutting lines including allowances; in the pattern only
    std::vector<VertexRun> notches;    ///< strokes; in the pattern only
    std::vector<VertexRun> internal;   ///< internal lines, and in the pattern marks of darts
    std::vector<VertexRun> leftOut;    ///< edges of omitted parts of files; on the garment only
    /// Outline of each piece, with the first vertex repeated at the end; empty if the piece is not
    /// a disk or, in the pattern, not flat.
    std::vector<VertexRun> outlines;
    /// Per piece, the indices of Piece::boundary's vertices in its outline, with the first repeated
    /// at the end; empty if the indices are equal.
    std::vector<std::vector<std::uint32_t>> boundaryAt;
};

/// Extent of a seam, for framing; empty if nothing of it is drawn.
struct SeamScene {
    Eigen::AlignedBox3d box;  ///< both sides, relative to Scene::origin
    /// Each side in the flat coordinates of its piece; empty if not flat.
    struct Side {
        int piece = -1;
        Eigen::AlignedBox2d flatBox{};
    };
    std::array<Side, 2> sides;
};

/// A rigid motion from a flat piece's own coordinates (x, y, 0) to the scene's.
struct SpaceMotion {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< proper: the third column is the normal
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();

    Eigen::Vector3d applied(const Eigen::Vector2d& point) const {
        return offset + turn.leftCols<2>() * point;
    }
};

/// Extent of a piece, for framing, picking and labels.
struct PieceScene {
    bool flat = false;
    Eigen::AlignedBox3d box;      ///< 3D, relative to Scene::origin
    Eigen::AlignedBox2d flatBox;  ///< in the piece's own coordinates; empty if not flat
    Eigen::Vector2d label = Eigen::Vector2d::Zero();  ///< a point well inside
    TriangleRun garmentRun, patternRun;
    geometry::TriangleTree<3> garmentTree;  ///< of garmentRun; indices relative to its first
    geometry::TriangleTree<2> patternTree;
    /// Vertices where the outline turns sharply: places in Piece::boundary, ascending.
    std::vector<int> corners;
    SpaceMotion rest;  ///< rigid fit of the flat piece to the worn one
};

/// The part of a scene that depends on pieces and results only. Edits of allowances, notches and
/// labels share it, so they upload no mesh and build no tree.
struct SceneCloth {
    /// Middle of the garment, subtracted in double precision. A garment far from the coordinate
    /// origin would lose precision in floats.
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    std::vector<ClothVertex> vertices;  ///< of all pieces, concatenated
    MeshIndices garment, pattern;       ///< in the pattern, of flat pieces only
    std::vector<FaceValues> faces;      ///< one per triangle of `pattern`
    StrainGlyphs glyphs;
    std::vector<PieceScene> pieces;
    /// By Overlay: the range of the garment's values. All directions of strain share one, so that
    /// they are comparable and independent of the grain. A fabric's limits take precedence.
    std::array<OverlayScale, kOverlayCount> scales;
    Eigen::AlignedBox3d box;  ///< relative to origin
    /// What it was made of; it does not keep a closed garment in memory.
    std::vector<std::weak_ptr<const Piece>> madeOf;
    std::vector<std::weak_ptr<const PieceResult>> results;
};

/// The cloth and the lines over it.
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
    /// Per piece: PieceScene::flatBox including its allowances.
    std::vector<Eigen::AlignedBox2d> edgeBoxes;

    const OverlayScale& scale(Overlay overlay) const {
        return cloth->scales[static_cast<std::size_t>(overlay)];
    }
};

/// Null if there is no scene.
inline const SceneCloth* clothOf(const std::shared_ptr<const Scene>& scene) {
    return scene ? scene->cloth.get() : nullptr;
}

/// Lines of a reference pattern over a scene's flat pieces. Separate from the scene, because their
/// pieces are matched later. Shared and immutable.
struct ReferenceLines {
    std::vector<LineVertex> vertices{};
    LineRuns runs{};  ///< only `LineRuns::reference` is used
};

/// Approximate memory use. Cost: negligible.
std::size_t bytesOf(const Scene& scene);

/// Per-piece data of the pattern view besides the shape.
struct SheetPlace {
    Placement placement{};
    double grain = kGrainUpwards;    ///< direction of the warp in the piece's own coordinates
    int colour = 0;                  ///< colour number (`pieceColour`)
    std::optional<Fabric> fabric{};  ///< of its material; nullopt: the garment's fabric
    bool hidden = false;             ///< not drawn in either view and not pickable

    bool operator==(const SheetPlace&) const = default;
};

/// One per piece of the scene. Missing entries mean the default place.
using SheetPlaces = std::vector<SheetPlace>;

/// @param colours    one per piece; empty if not needed
/// @param materials  materials of the pieces; empty if fabrics are not needed
SheetPlaces placesOf(const std::vector<PieceSettings>& settings,
                     const std::vector<int>& colours = {}, const MaterialList& materials = {});

const SheetPlace& placeOf(const SheetPlaces& places, int piece);

/// The bounding box of a placed box; empty if that is empty.
Eigen::AlignedBox2d placedBox(const Eigen::AlignedBox2d& box, const Placement& placement);

/// Around both sides of a seam at their places; empty if neither is flat.
Eigen::AlignedBox2d placedBox(const SeamScene& seam, const SheetPlaces& places);

/// The pieces that are not hidden; all of them if every one is hidden.
std::set<int> seenOf(const std::set<int>& pieces, const SheetPlaces& places);

/// Bounding box of all visible flat pieces at their places.
Eigen::AlignedBox2d sheetBox(const Scene& scene, const SheetPlaces& places);

}  // namespace toile::app
