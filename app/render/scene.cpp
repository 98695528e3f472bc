// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "app/render/overlay_values.h"
#include "core/quality/metric_tensor.h"

namespace toile::app {
namespace {

constexpr double kMaxGlyphs = 40000;
/// Levels of density. Each keeps half of the previous one's places, like the black squares of a
/// chessboard; every second one is an upright lattice again.
constexpr int kLevels = 24;
constexpr double kPercentPerShare = 100;

/// The triangle whose centre is nearest to a lattice point.
struct Nearest {
    std::size_t face = 0;
    double distance = 0;
};

struct Place {
    std::int32_t column = 0, row = 0;
    std::size_t face = 0;

    int level() const {
        const auto bits = static_cast<std::uint32_t>(column) | static_cast<std::uint32_t>(row);
        const int halvings = std::countr_zero(bits);
        if (halvings >= kLevels / 2) {
            return kLevels - 1;
        }
        const bool isBlack = ((column >> halvings) + (row >> halvings)) % 2 == 0;
        return 2 * halvings + (isBlack ? 1 : 0);
    }
};

double finestSpacing(const Scene& scene) {
    double area = 0;
    for (const FaceValues& face : scene.faces) {
        area += static_cast<double>(face.flatArea);
    }
    const double count = std::min(kMaxGlyphs, static_cast<double>(scene.faces.size()));
    return count > 0 && area > 0 ? std::sqrt(area / count) : 1.0;
}

/// One place per lattice point with cloth around it. The lattice goes through the piece's label
/// point, so each piece has a place of the coarsest level, well inside.
std::vector<Place> placesOf(const Scene& scene, const PieceScene& piece, double spacing) {
    std::unordered_map<std::uint64_t, Nearest> cells;
    const std::size_t first = piece.patternRun.first;
    for (std::size_t face = first; face < first + piece.patternRun.count; ++face) {
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            middle += flatPoint(scene.vertices[scene.pattern.triangles[3 * face + k]]) / 3;
        }
        const Eigen::Vector2d cell = (middle - piece.label) / spacing;
        const double limit = 1e9;
        if (!(cell.cwiseAbs().maxCoeff() < limit)) {
            continue;
        }
        const Eigen::Vector2d lattice = cell.array().round();
        const auto column = static_cast<std::int32_t>(lattice.x());
        const auto row = static_cast<std::int32_t>(lattice.y());
        const double distance = (cell - lattice).squaredNorm();
        const std::uint64_t key = std::uint64_t{static_cast<std::uint32_t>(column)} << 32U |
                                  static_cast<std::uint32_t>(row);
        const auto [entry, isNew] = cells.try_emplace(key, Nearest{face, distance});
        if (!isNew && distance < entry->second.distance) {
            entry->second = {face, distance};
        }
    }
    std::vector<Place> places;
    places.reserve(cells.size());
    for (const auto& [key, nearest] : cells) {
        places.push_back(
            {static_cast<std::int32_t>(key >> 32U), static_cast<std::int32_t>(key), nearest.face});
    }
    return places;
}

GlyphVertex glyphOf(const Scene& scene, std::size_t face, float index) {
    constexpr double kThird = 1.0 / 3;
    Eigen::Vector2d u[3], middle = Eigen::Vector2d::Zero();
    Eigen::Vector3d X[3], position3 = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        const ClothVertex& corner = scene.vertices[scene.pattern.triangles[3 * face + k]];
        u[k] = flatPoint(corner);
        X[k] = wornPoint(corner);
        middle += kThird * u[k];
        position3 += kThird * X[k];
    }
    const OverlaySample sample = sampleOf(scene, face, Eigen::Vector3d::Constant(kThird), false);
    const PrincipalStretch stretch = principalStretch({static_cast<double>(sample.metric[0]),
                                                       static_cast<double>(sample.metric[1]),
                                                       static_cast<double>(sample.metric[2])});
    // Map a direction of the flat cloth to the garment; the length is irrelevant.
    const Eigen::Vector2d u1 = u[1] - u[0], u2 = u[2] - u[0];
    const Eigen::Vector3d X1 = X[1] - X[0], X2 = X[2] - X[0];
    const double sign = u1.x() * u2.y() - u1.y() * u2.x() < 0 ? -1.0 : 1.0;
    const auto lifted = [&](const Eigen::Vector2d& d) -> Eigen::Vector3d {
        return sign *
               ((d.x() * u2.y() - d.y() * u2.x()) * X1 + (u1.x() * d.y() - u1.y() * d.x()) * X2);
    };
    const Eigen::Vector2d along = stretch.direction, across(-along.y(), along.x());

    GlyphVertex vertex{};
    Eigen::Map<Eigen::Vector3f>(vertex.position) = position3.cast<float>();
    Eigen::Map<Eigen::Vector2f>(vertex.flat) = middle.cast<float>();
    Eigen::Map<Eigen::Vector2f>(vertex.flatAlong) = along.cast<float>();
    Eigen::Map<Eigen::Vector3f>(vertex.along) = lifted(along).normalized().cast<float>();
    Eigen::Map<Eigen::Vector3f>(vertex.across) = lifted(across).normalized().cast<float>();
    vertex.strain[0] = static_cast<float>(kPercentPerShare * (stretch.largest - 1));
    vertex.strain[1] = static_cast<float>(kPercentPerShare * (stretch.least - 1));
    vertex.piece = index;
    return vertex;
}

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

GlyphRange glyphsAt(const StrainGlyphs& glyphs, double leastSpacing) {
    if (glyphs.counts.empty()) {
        return {};
    }
    std::size_t level = 0;
    double spacing = glyphs.finest;
    while (spacing < leastSpacing && level + 1 < glyphs.counts.size()) {
        spacing *= std::numbers::sqrt2;
        ++level;
    }
    return {glyphs.counts[level], spacing};
}

StrainGlyphs makeStrainGlyphs(const Scene& scene) {
    StrainGlyphs glyphs;
    glyphs.finest = finestSpacing(scene);
    std::vector<std::pair<int, Place>> places;  // piece index and place
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
        if (scene.pieces[i].flat) {
            for (const Place& place : placesOf(scene, scene.pieces[i], glyphs.finest)) {
                places.emplace_back(static_cast<int>(i), place);
            }
        }
    }
    // Coarsest first. Within a level use the mesh's order, independent of the hash map.
    std::ranges::sort(places, [](const auto& a, const auto& b) -> bool {
        return std::pair(-a.second.level(), a.second.face) <
               std::pair(-b.second.level(), b.second.face);
    });
    glyphs.vertices.reserve(places.size());
    glyphs.counts.assign(kLevels, 0);
    for (const auto& [piece, place] : places) {
        glyphs.vertices.push_back(glyphOf(scene, place.face, static_cast<float>(piece)));
        for (int level = 0; level <= place.level(); ++level) {
            ++glyphs.counts[static_cast<std::size_t>(level)];
        }
    }
    return glyphs;
}

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
    const auto at = static_cast<std::size_t>(piece);  // -1 wraps beyond any list
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
                placedBox(scene.edgeBoxes[i], placeOf(places, static_cast<int>(i)).placement));
        }
    }
    return box;
}

}  // namespace toile::app
