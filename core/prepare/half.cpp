// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/half.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/polygon.h"
#include "core/geometry/segment.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/repair.h"
#include "core/prepare/file_surface.h"

namespace toile {
namespace {

using Plane = Eigen::Hyperplane<double, 3>;

/// How far rims may lie off the plane, relative to a garment's size.
constexpr double kHalfTolerance = 1e-3;
/// Relative to a garment's size: the minimum depth off the plane, the minimum spread of the rims in
/// it, seen from above, and their minimum length if the user did not say that it is half.
constexpr double kMinDepth = 0.05, kMinSpread = 0.05, kOfferedLength = 0.5;
/// Minimum shares of all rims in the plane: offered, stated, and without any other rim.
constexpr double kOfferedShare = 0.2, kStatedShare = 0.05, kNoOtherRim = 0.99;
/// Minimum share of the rims in the plane that go up or down: those of flat panels do not.
constexpr double kRising = 0.3;
/// Minimum share of the rims in the plane that counts as a separate place.
constexpr double kChainShare = 0.1;

/// Input of the search.
struct HalfRims {
    double lengthOf(const std::pair<int, int>& rim) const {
        return (V->row(rim.first) - V->row(rim.second)).norm();
    }

    const Points3* V = nullptr;
    std::vector<int> used;                  ///< vertices
    std::vector<int> part;                  ///< per vertex: its connected part
    std::vector<std::pair<int, int>> rims;  ///< edges of the border
    double length = 0;                      ///< of these, mm
    bool isOne = false;                     ///< all connected, like those of a panel
    double size = 0;                        ///< of the garment, mm
    Eigen::Vector3d along[2];               ///< the two level axes
};

double sizeOf(const MeshArrays& mesh) {
    Eigen::AlignedBox3d box;
    for (Eigen::Index i = 0; i < mesh.F.size(); ++i) {
        box.extend(mesh.V.row(mesh.F.data()[i]).transpose());
    }
    return box.isEmpty() ? 0 : box.diagonal().norm();
}

HalfRims rimsOfHalf(const MeshArrays& mesh, UpAxis up) {
    HalfRims found;
    found.V = &mesh.V;
    found.size = sizeOf(mesh);
    found.along[0] = Eigen::Vector3d::UnitX();
    found.along[1] = up == UpAxis::Y ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    const std::vector<char> isUsed = usedVertices(mesh.F, mesh.V.rows());
    for (int v = 0; v < mesh.V.rows(); ++v) {
        if (isUsed[v] != 0) {
            found.used.push_back(v);
        }
    }
    const Triangles faces = weldedFaces(mesh);
    const EdgeTable table = buildEdgeTable(faces, static_cast<int>(mesh.V.rows()));
    geometry::DisjointSets loops(static_cast<int>(mesh.V.rows())), parts = loops;
    for (Eigen::Index f = 0; f < faces.rows(); ++f) {
        parts.join(faces(f, 0), faces(f, 1));
        parts.join(faces(f, 0), faces(f, 2));
    }
    for (int v = 0; v < mesh.V.rows(); ++v) {
        found.part.push_back(parts.root(v));
    }
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        if (table.isBorder(e)) {
            const int a = table.edges(e, 0), b = table.edges(e, 1);
            found.rims.emplace_back(a, b);
            found.length += found.lengthOf(found.rims.back());
            loops.join(a, b);
        }
    }
    found.isOne = std::ranges::all_of(found.rims, [&](const auto& rim) {
        return loops.root(rim.first) == loops.root(found.rims.front().first);
    });
    return found;
}

/// The rims in a plane.
struct RimsInPlane {
    double open = 0;        ///< mm, of those that continue outside it
    double closed = 0;      ///< mm, of openings entirely within it
    double spread = 0;      ///< their extent seen from above, mm
    double rise = 0;        ///< vertical extent of the open ones, mm
    int chains = 0;         ///< number of long open ones
    bool isBeside = false;  ///< parts side by side, each of which would close to its own tube
};

/// The rims of one part in the plane, by their position along it, mm.
struct PartInPlane {
    double from = 0, to = 0;
    int chains = 0;
};

/// Half a garment goes around once, with its lining inside; two strips next to each other go around
/// twice.
bool areBeside(const std::map<int, PartInPlane>& parts, double leastSpread) {
    std::vector<PartInPlane> round;
    for (const auto& [part, in] : parts) {
        if (in.chains > 1 && in.to - in.from >= leastSpread) {
            round.push_back(in);
        }
    }
    std::ranges::sort(round, {}, &PartInPlane::from);
    double reached = round.empty() ? 0 : round.front().to;
    return std::ranges::any_of(round, [&reached](const PartInPlane& in) {
        const bool isApart = in.from > reached;
        reached = std::max(reached, in.to);
        return isApart;
    });
}

RimsInPlane rimsIn(const HalfRims& half, const Plane& plane, double tolerance) {
    const auto isIn = [&](int v) {
        return std::abs(plane.signedDistance(half.V->row(v).transpose())) <= tolerance;
    };
    double all = 0;
    for (const auto& rim : half.rims) {
        all += isIn(rim.first) && isIn(rim.second) ? half.lengthOf(rim) : 0;
    }
    if (all < kStatedShare * half.length) {
        return {};  // true for most planes: the rest takes longer
    }
    geometry::DisjointSets chains(static_cast<int>(half.V->rows()));
    std::vector<char> goesOn(static_cast<std::size_t>(half.V->rows()), 0);
    for (const auto& [a, b] : half.rims) {
        const bool first = isIn(a), second = isIn(b);
        if (first && second) {
            chains.join(a, b);
        } else {
            goesOn[first ? a : b] |= static_cast<char>(first || second);
        }
    }
    for (int v = 0; v < half.V->rows(); ++v) {
        if (goesOn[v] != 0) {
            goesOn[chains.root(v)] = 1;
        }
    }
    const Eigen::Vector3d upright = half.along[0].cross(half.along[1]);
    const Eigen::Vector3d level = upright.cross(plane.normal());
    RimsInPlane found;
    std::vector<double> ofChain(static_cast<std::size_t>(half.V->rows()), 0);
    std::map<int, PartInPlane> ofPart;
    double least = 0, most = 0;
    bool isAny = false;
    for (const auto& [a, b] : half.rims) {
        if (!isIn(a) || !isIn(b)) {
            continue;
        }
        const double length = half.lengthOf({a, b});
        const int chain = chains.root(a);
        (goesOn[chain] != 0 ? found.open : found.closed) += length;
        if (goesOn[chain] != 0) {
            ofChain[chain] += length;
            found.rise += std::abs((half.V->row(b) - half.V->row(a)) * upright);
        }
        for (const int v : {a, b}) {
            const double at = half.V->row(v) * level;
            least = isAny ? std::min(least, at) : at;
            most = isAny ? std::max(most, at) : at;
            isAny = true;
            PartInPlane& in = ofPart.try_emplace(half.part[v], PartInPlane{at, at}).first->second;
            in = {std::min(in.from, at), std::max(in.to, at)};
        }
    }
    found.spread = most - least;
    for (int chain = 0; chain < half.V->rows(); ++chain) {
        if (ofChain[chain] > 0 && ofChain[chain] >= kChainShare * found.open) {
            ++found.chains;
            ++ofPart[half.part[chain]].chains;
        }
    }
    found.isBeside = areBeside(ofPart, kMinSpread * half.size);
    return found;
}

/// Whether these rims alone indicate half a garment.
bool mayBeOffered(const HalfRims& half, const RimsInPlane& in) {
    return in.open >= kOfferedShare * half.length && in.open >= kOfferedLength * half.size &&
           in.spread >= kMinSpread * half.size && in.rise >= kRising * in.open && !in.isBeside &&
           (in.chains > 1 || !half.isOne);
}

/// The plane oriented so that its normal points at the cloth; nothing if cloth lies on both sides
/// or nowhere off it.
std::optional<Plane> besideCloth(const HalfRims& half, const Plane& plane, double tolerance) {
    double least = 0, most = 0;
    for (const int v : half.used) {
        const double distance = plane.signedDistance(half.V->row(v).transpose());
        least = std::min(least, distance);
        most = std::max(most, distance);
    }
    if (std::min(-least, most) > tolerance || std::max(-least, most) < kMinDepth * half.size) {
        return std::nullopt;
    }
    return most >= -least ? plane : Plane(-plane.normal(), -plane.offset());
}

/// The convex hull of the rims seen from above.
geometry::Polygon outlineFromAbove(const HalfRims& half) {
    geometry::Polygon points(2 * static_cast<Eigen::Index>(half.rims.size()), 2);
    Eigen::Index k = 0;
    for (const auto& [a, b] : half.rims) {
        for (const int v : {a, b}) {
            points.row(k++) << half.V->row(v) * half.along[0], half.V->row(v) * half.along[1];
        }
    }
    return geometry::convexHull(points);
}

/// Candidate mirror planes, the most likely first; the first two are the file's own.
std::vector<Plane> candidates(const HalfRims& half) {
    std::vector<Plane> planes{{half.along[0], 0}, {half.along[1], 0}};
    const geometry::Polygon hull = outlineFromAbove(half);
    for (Eigen::Index k = 0; k < hull.rows(); ++k) {
        const Eigen::Vector2d way = hull.row((k + 1) % hull.rows()) - hull.row(k);
        if (way.norm() >= kMinSpread * half.size) {
            const Eigen::Vector2d inwards = geometry::leftOf(way.normalized());
            const Eigen::Vector3d normal =
                inwards.x() * half.along[0] + inwards.y() * half.along[1];
            planes.emplace_back(normal, -hull.row(k).dot(inwards));
        }
    }
    // A flat panel has no outline from above: use its ends.
    for (const Eigen::Vector3d& axis : half.along) {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        for (const int v : half.used) {
            const double at = half.V->row(v).dot(axis);
            least = std::min(least, at);
            most = std::max(most, at);
        }
        planes.emplace_back(axis, -least);
        planes.emplace_back(-axis, most);
    }
    return planes;
}

}  // namespace

double halfTolerance(const MeshArrays& mesh) {
    return kHalfTolerance * sizeOf(mesh);
}

std::optional<HalfPlane> findHalfPlane(const FileSurface& surface, UpAxis up, bool isStated) {
    const HalfRims half = rimsOfHalf(surface.mesh, up);
    if (half.rims.empty() || !(half.size > 0) || !std::isfinite(half.size)) {
        return std::nullopt;
    }
    const double tolerance = kHalfTolerance * half.size;
    std::vector<HalfPlane> offered;  // the file's own planes first
    std::optional<HalfPlane> longest;
    int index = 0;
    for (const Plane& candidate : candidates(half)) {
        const bool isOfFile = index++ < 2;
        const RimsInPlane in = rimsIn(half, candidate, tolerance);
        const double length =
            isStated && in.closed > kNoOtherRim * half.length ? in.closed : in.open;
        const bool isGood = mayBeOffered(half, in);
        const auto plane = isGood || (isStated && length >= kStatedShare * half.length)
                               ? besideCloth(half, candidate, tolerance)
                               : std::nullopt;
        if (plane && isGood) {
            offered.push_back({*plane, length, false});
            if (isOfFile && isStated) {
                break;
            }
        }
        if (plane && (!longest || length > longest->length)) {
            longest = HalfPlane{*plane, length, false};
        }
    }
    if (isStated) {
        return offered.empty() ? longest : offered.front();
    }
    // Panels that are not sewn yet have such rims on both sides.
    const bool isOnBothSides = std::ranges::any_of(offered, [&](const HalfPlane& other) {
        return other.plane.normal().dot(offered.front().plane.normal()) < 0;
    });
    return offered.empty() || isOnBothSides ? std::nullopt : std::optional(offered.front());
}

namespace {

/// Per position: whether it, or another one at the same place, is on the border.
std::vector<char> onBorder(const MeshArrays& mesh) {
    const Triangles F = weldedFaces(mesh);
    const EdgeTable table = buildEdgeTable(F, static_cast<int>(mesh.V.rows()));
    std::vector<char> border(static_cast<std::size_t>(mesh.V.rows()), 0);
    for (int e = 0; e < table.edges.rows(); ++e) {
        if (table.isBorder(e)) {
            border[table.edges(e, 0)] = border[table.edges(e, 1)] = 1;
        }
    }
    for (Eigen::Index i = 0; i < F.size(); ++i) {
        border[mesh.F.data()[i]] = border[F.data()[i]];
    }
    return border;
}

/// Adds the mirror image of a UV map, to its right. @return the offset to add to an index
int mirrorMap(std::vector<Eigen::Vector2d>& uvs) {
    constexpr double kGap = 0.05;  // of the map's width
    const auto count = static_cast<int>(uvs.size());
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Eigen::Vector2d& uv : uvs) {
        if (uv.allFinite()) {
            least = std::min(least, uv.x());
            most = std::max(most, uv.x());
        }
    }
    if (least > most) {
        least = most = 0;  // no finite values
    }
    const double sum = 2 * most + kGap * (most - least);
    for (int k = 0; k < count; ++k) {
        uvs.emplace_back(sum - uvs[k].x(), uvs[k].y());
    }
    return count;
}

/// The name of the mirror image: "sleeve_left" of "sleeve_right".
std::string mirroredName(const std::string& name) {
    constexpr std::pair<std::string_view, std::string_view> kSides[] = {
        {"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}};
    for (const auto& [left, right] : kSides) {
        for (const auto& [one, other] : {std::pair(left, right), std::pair(right, left)}) {
            const std::size_t at = name.find(one);
            const auto isLetter = [&name](std::size_t k) {
                return k < name.size() && std::islower(static_cast<unsigned char>(name[k])) != 0;
            };
            // A whole word, as in "sleeveLeft"; not "bright" or "Leftover".
            const bool isWithin = at != std::string::npos &&
                                  ((isLetter(at) && isLetter(at - 1)) || isLetter(at + one.size()));
            if (at != std::string::npos && !isWithin) {
                return std::string(name).replace(at, one.size(), other);
            }
        }
    }
    return name;
}

/// Adds the names of the images, face by face.
void nameImages(std::vector<int>& perFace, std::vector<std::string>& names) {
    std::vector<int> image(names.size());
    for (std::size_t k = 0; k < image.size(); ++k) {
        std::string name = mirroredName(names[k]);
        const auto found = std::ranges::find(names, name);
        image[k] = static_cast<int>(found - names.begin());
        if (found == names.end()) {
            names.push_back(std::move(name));
        }
    }
    const std::size_t count = perFace.size();
    for (std::size_t face = 0; face < count; ++face) {
        perFace.push_back(perFace[face] < 0 ? -1 : image[perFace[face]]);
    }
}

}  // namespace

std::optional<CompletedHalf> completeHalf(const PolygonSoup& half,
                                          const Eigen::Hyperplane<double, 3>& plane,
                                          double tolerance, double millimetres) {
    const FileSurface surface = surfaceOf(half, millimetres);
    const std::vector<char> border = onBorder(surface.mesh);
    const std::vector<char> used = usedVertices(surface.mesh.F, surface.mesh.V.rows());
    CompletedHalf whole{half, 0};
    PolygonSoup& soup = whole.soup;
    double least = 0, most = 0;
    std::vector<int> image(half.positions.size());  // same index on the plane
    for (std::size_t v = 0; v < half.positions.size(); ++v) {
        image[v] = static_cast<int>(soup.positions.size());
        if (!half.positions[v].allFinite()) {
            soup.positions.push_back(half.positions[v]);
            continue;
        }
        const Eigen::Vector3d here = millimetres * half.positions[v];
        const double distance = plane.signedDistance(here);
        const Eigen::Vector3d foot = plane.projection(here) / millimetres;
        if (used[v] != 0) {
            least = std::min(least, distance);
            most = std::max(most, distance);
        }
        if (border[v] != 0 && used[v] != 0 && std::abs(distance) <= tolerance) {
            image[v] = static_cast<int>(v);
            whole.joined += 1;
            if (foot != half.positions[v] && !soup.positionText.empty()) {
                soup.positionText[v] = {};  // it has moved
            }
            soup.positions[v] = foot;
        } else {
            soup.positions.push_back(2 * foot - half.positions[v]);
        }
    }
    if (whole.joined == 0 || std::min(-least, most) > tolerance) {
        return std::nullopt;
    }
    if (!soup.positionText.empty()) {
        soup.positionText.resize(soup.positions.size());
    }
    const int toImage = half.uvs.empty() ? 0 : mirrorMap(soup.uvs);
    for (int face = 0; face < half.faceCount(); ++face) {
        for (int corner = half.faceStart[face + 1] - 1; corner >= half.faceStart[face]; --corner) {
            soup.corners.push_back(image[half.corners[corner]]);
            if (!half.cornerUvs.empty()) {
                const int uv = half.cornerUvs[corner];
                soup.cornerUvs.push_back(uv < 0 ? uv : uv + toImage);
            }
        }
        soup.faceStart.push_back(static_cast<int>(soup.corners.size()));
    }
    nameImages(soup.faceObject, soup.objects);
    nameImages(soup.faceGroup, soup.groups);
    nameImages(soup.faceMaterial, soup.materials);
    return whole;
}

namespace {

/// "x = 12.5 mm", or a point on the plane.
Wording planeWording(const Eigen::Hyperplane<double, 3>& plane) {
    const Eigen::Vector3d foot = plane.projection(Eigen::Vector3d::Zero());
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(plane.normal()[axis]) == 1) {
            constexpr const char* kNames[] = {"x", "y", "z"};
            return worded("the plane %1 = %2 mm", {Wording(kNames[axis]), figure(foot[axis], 1)});
        }
    }
    return worded("the upright plane through %1 mm", {placeWording(foot.x(), foot.y(), foot.z())});
}

/// Files that only look like their kind, without certainty, are not tested for halves.
bool mayBeHalf(const FileReading& reading) {
    return reading.kind != FileKind::Solid && (reading.kind != FileKind::Scan || reading.isStated);
}

}  // namespace

void takeHalf(PreparedFile& file, const Preparation& preparation, UpAxis up, double millimetres,
              const std::string& name) {
    if (!preparation.isHalf && !mayBeHalf(file.reading)) {
        return;
    }
    const FileSurface surface = surfaceOf(*file.soup, millimetres);
    std::optional<HalfPlane>& half = file.reading.half;
    half = findHalfPlane(surface, up, preparation.isHalf);
    if (!preparation.isHalf) {
        return;
    }
    auto whole =
        half ? completeHalf(*file.soup, half->plane, halfTolerance(surface.mesh), millimetres)
             : std::nullopt;
    if (!whole) {
        half.reset();
        file.problems.push_back(
            {ErrorCode::CannotReadAs, Subject::file(name),
             worded("half a garment needs rims in an upright plane with all cloth on one side, and "
                    "there is no such plane; check which axis points up")});
        return;
    }
    const int faces = file.soup->faceCount();
    half->isCompleted = true;
    std::vector<int>& layers = file.reading.layerOfFace;
    layers.reserve(2 * layers.size());
    std::copy_n(layers.begin(), layers.size(), std::back_inserter(layers));
    file.soup = std::make_shared<const PolygonSoup>(std::move(whole->soup));
    file.problems.push_back(
        {ErrorCode::ReadAs, Subject::file(name),
         worded(
             "half a garment: the mirror image of its %1 is added and joined along %2 mm in %3",
             {countWording(faces, "face"), figure(half->length, 0), planeWording(half->plane)})});
}

}  // namespace toile
