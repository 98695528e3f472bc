// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/scene.h"

namespace toile::app {

namespace {

template <class Value>
std::size_t bytesOf(const std::vector<Value>& values) {
    return values.capacity() * sizeof(Value);
}

std::size_t bytesOf(const MeshIndices& mesh) {
    return bytesOf(mesh.triangles) + bytesOf(mesh.edges) + bytesOf(mesh.outline);
}

std::size_t bytesOf(const LineRuns& lines) {
    return bytesOf(lines.seams) + bytesOf(lines.reference) + bytesOf(lines.exact) +
           bytesOf(lines.outlines) + bytesOf(lines.cutting) + bytesOf(lines.notches) +
           bytesOf(lines.internal);
}

}  // namespace

std::size_t bytesOf(const Scene& scene) {
    std::size_t bytes = sizeof(Scene) + bytesOf(scene.vertices) + bytesOf(scene.garment) +
                        bytesOf(scene.pattern) + bytesOf(scene.lineVertices) +
                        bytesOf(scene.garmentLines) + bytesOf(scene.patternLines) +
                        bytesOf(scene.faces) + bytesOf(scene.glyphs.vertices) +
                        bytesOf(scene.pieces) + bytesOf(scene.seams);
    for (const PieceScene& piece : scene.pieces) {
        bytes += piece.garmentTree.bytes() + piece.patternTree.bytes() + bytesOf(piece.corners);
    }
    return bytes;
}

SheetPlaces placesOf(const std::vector<PieceSettings>& settings, const std::vector<int>& colours,
                     const MaterialList& materials) {
    SheetPlaces places;
    places.reserve(settings.size());
    for (const PieceSettings& piece : settings) {
        const std::size_t at = places.size();
        places.push_back({piece.placement.value_or(Placement{}), grainOf(piece),
                          at < colours.size() ? colours[at] : 0});
        places.back().hidden = piece.hidden;
        if (const Material* material = findMaterial(piece.material, materials)) {
            places.back().fabric = material->fabric;
        }
    }
    return places;
}

const SheetPlace& placeOf(const SheetPlaces& places, int piece) {
    static const SheetPlace kAsMade;
    const auto at = static_cast<std::size_t>(piece);  // of -1 beyond any list
    return at < places.size() ? places[at] : kAsMade;
}

Eigen::AlignedBox2d placedBox(const Eigen::AlignedBox2d& box, const Placement& placement) {
    Eigen::AlignedBox2d placed;
    if (!box.isEmpty()) {
        for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                                  Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight}) {
            placed.extend(placement.applied(box.corner(corner)));
        }
    }
    return placed;
}

Eigen::AlignedBox2d placedBox(const SeamScene& seam, const SheetPlaces& places) {
    Eigen::AlignedBox2d box;
    for (const SeamScene::Side& side : seam.sides) {
        box.extend(placedBox(side.flatBox, placeOf(places, side.piece).placement));
    }
    return box;
}

std::set<int> seenOf(const std::set<int>& pieces, const SheetPlaces& places) {
    std::set<int> seen = pieces;
    std::erase_if(seen, [&places](int piece) { return placeOf(places, piece).hidden; });
    return seen.empty() ? pieces : seen;
}

Eigen::AlignedBox2d sheetBox(const Scene& scene, const SheetPlaces& places) {
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        if (scene.pieces[i].flat && !placeOf(places, static_cast<int>(i)).hidden) {
            box.extend(
                placedBox(scene.pieces[i].edgeBox, placeOf(places, static_cast<int>(i)).placement));
        }
    }
    return box;
}

}  // namespace toile::app
