// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/shell_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/geometry/disjoint_sets.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/weld.h"
#include "core/prepare/shell.h"
#include "core/prepare/two_sided.h"

namespace toile::shell {
namespace {

/// 1 - cosine of the angle up to which two triangles are one surface, whatever is opposite: 40
/// degrees, as a rim turns by 90.
inline constexpr double kSmooth = 0.23;
/// Two triangles that share an edge.
struct Neighbours {
    int a, b;
    double bend;    ///< 1 - cosine of the angle between them
    double length;  ///< of the edge, mm
};

/// If more than two meet, as at a seam of thick panels, none continues smoothly.
constexpr double kManyMeet = 2;
/// At most this many triangles at one edge are all neighbours; of more, those adjacent in the file.
constexpr std::size_t kMaxAtEdge = 8;

/// Maximum share of openings around both surfaces in the length of a shell's edges.
constexpr double kMaxShared = 0.04;
/// Maximum share of an island in a file's area to be taken for a mistake.
constexpr double kIsland = 1e-3;
/// Maximum width of a rim, in multiples of the thickness.
constexpr double kWidestRim = 4;

/// The edges at the end of one shell's surfaces, at a rim, at each other or open; lengths.
struct Edging {
    double all = 0;
    double shared = 0;  ///< of openings that run along both surfaces

    bool isShells() const { return shared <= kMaxShared * all; }
};

std::size_t numberOf(ShellSide side) {
    return static_cast<std::size_t>(side);
}

/// The sides along each opening: open edges by their first vertex.
struct Openings {
    geometry::DisjointSets sets;
    std::vector<std::array<bool, 4>> along;  ///< per root

    bool areShared(int vertex) {
        const auto& sides = along[sets.root(vertex)];
        return sides[numberOf(ShellSide::Outer)] && sides[numberOf(ShellSide::Inner)];
    }
};

Openings openingsOf(const EdgeTable& table, int vertexCount, const Sides& sides) {
    Openings openings{geometry::DisjointSets(vertexCount), {}};
    openings.along.resize(static_cast<std::size_t>(vertexCount));
    const auto eachOpen = [&table](const auto& visit) {
        for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
            if (table.isBorder(e)) {
                visit(e);
            }
        }
    };
    eachOpen([&](auto e) { openings.sets.join(table.edges(e, 0), table.edges(e, 1)); });
    eachOpen([&](auto e) {
        const ShellSide side = sides.side[table.usesOf(e)[0] / 3];
        openings.along[openings.sets.root(table.edges(e, 0))][numberOf(side)] = true;
    });
    return openings;
}

/// Reassigns small islands of one surface in the other, or of neither, to their surroundings.
void takeOverIslands(const Surface& surface, const std::vector<Neighbours>& neighbours,
                     TwoSided& sets, Sides& sides) {
    const int count = static_cast<int>(sides.side.size());
    geometry::DisjointSets islands(count);
    for (const Neighbours& pair : neighbours) {
        if (sides.side[pair.a] == sides.side[pair.b]) {
            islands.join(pair.a, pair.b);
        }
    }
    struct Island {
        double area = 0, length = 0;
        std::array<double, 4> beside{};  ///< lengths
        std::array<int, 4> like{};       ///< one triangle there
    };
    std::vector<Island> all(static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t) {
        all[islands.root(t)].area += surface.area[t];
    }
    for (const Neighbours& pair : neighbours) {
        for (const auto& [t, other] : {std::pair(pair.a, pair.b), std::pair(pair.b, pair.a)}) {
            if (sides.side[t] != sides.side[other]) {
                Island& island = all[islands.root(t)];
                island.length += pair.length;
                island.beside[numberOf(sides.side[other])] += pair.length;
                island.like[numberOf(sides.side[other])] = other;
            }
        }
    }
    const std::vector<ShellSide> before = sides.side;
    const double largest = kIsland * surface.area.sum();
    for (int t = 0; t < count; ++t) {
        const Island& island = all[islands.root(t)];
        for (const ShellSide side : {ShellSide::Outer, ShellSide::Inner, ShellSide::Rim}) {
            const double beside = island.beside[numberOf(side)];
            const bool mayBe =
                before[t] == ShellSide::Single || (isSide(before[t]) && side != ShellSide::Rim);
            if (mayBe && island.area <= largest && beside > island.length / 2) {
                const int like = island.like[numberOf(side)];
                sides.side[t] = side;
                sides.turned[t] = sides.turned[like];
                sets.join(t, like, false);
            }
        }
    }
}

/// All pairs that share an edge. Cost: linear.
std::vector<Neighbours> neighboursOf(const Surface& surface, const EdgeTable& table) {
    const MeshArrays& mesh = surface.mesh;
    std::vector<Neighbours> all;
    all.reserve(static_cast<std::size_t>(table.edges.rows()));
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        const auto uses = table.usesOf(e);
        const double length =
            (mesh.V.row(table.edges(e, 0)) - mesh.V.row(table.edges(e, 1))).norm();
        for (std::size_t i = 0; i < uses.size(); ++i) {
            const std::size_t last = uses.size() > kMaxAtEdge ? i + 2 : uses.size();
            for (std::size_t j = i + 1; j < std::min(last, uses.size()); ++j) {
                const int a = uses[i] / 3, b = uses[j] / 3;
                const double sign = tailOf(mesh.F, uses[i]) == tailOf(mesh.F, uses[j]) ? -1 : 1;
                const double cosine = sign * surface.normal.row(a).dot(surface.normal.row(b));
                all.push_back({a, b, uses.size() == 2 ? 1 - cosine : kManyMeet, length});
            }
        }
    }
    return all;
}

/// Assigns each patch of single triangles to its surroundings: those it joins smoothly, or else all
/// around; a narrow one between the two surfaces is a rim. Small islands of one surface in the
/// other are reassigned to the other.
/// @param thickness  of the cloth, mm   @param sets  are joined with the surroundings
void fillIn(const Surface& surface, const Pairs& pairs, const std::vector<Neighbours>& neighbours,
            double thickness, TwoSided& sets, Sides& sides) {
    const int count = static_cast<int>(sides.side.size());
    const auto isOpen = [&](int t) { return sides.side[t] == ShellSide::Single; };
    geometry::DisjointSets patches(count);
    for (const Neighbours& pair : neighbours) {
        if (isOpen(pair.a) && isOpen(pair.b) && pairs.isRim[pair.a] == pairs.isRim[pair.b] &&
            pair.bend <= kSmooth) {
            patches.join(pair.a, pair.b);
        }
    }
    struct Patch {
        double area = 0, length = 0;
        std::array<double, 2> smooth{}, around{};  ///< lengths along the outer and inner surface
        std::array<int, 2> like{};                 ///< one triangle there
    };
    std::vector<Patch> all(static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t) {
        if (isOpen(t)) {
            all[patches.root(t)].area += surface.area[t];
        }
    }
    for (const Neighbours& pair : neighbours) {
        if (isOpen(pair.a) == isOpen(pair.b)) {
            continue;
        }
        const auto [open, done] =
            isOpen(pair.a) ? std::pair(pair.a, pair.b) : std::pair(pair.b, pair.a);
        Patch& patch = all[patches.root(open)];
        const std::size_t side = sides.side[done] == ShellSide::Outer ? 0 : 1;
        patch.length += pair.length;
        patch.around[side] += pair.length;
        patch.smooth[side] += pair.bend <= kSmooth ? pair.length : 0;
        patch.like[side] = done;
    }
    for (int t = 0; t < count; ++t) {
        if (!isOpen(t)) {
            continue;
        }
        const Patch& patch = all[patches.root(t)];
        const bool isSmooth = patch.smooth[0] + patch.smooth[1] > 0;
        const auto& lengths = isSmooth ? patch.smooth : patch.around;
        if (patch.length > 0 && (pairs.isRim[t] != 0 || (lengths[0] > 0 && lengths[1] > 0))) {
            const bool isNarrow = patch.area <= kWidestRim / 2 * thickness * patch.length;
            sides.side[t] = isNarrow ? ShellSide::Rim : ShellSide::Single;
            if (isNarrow) {
                sets.join(t, patch.like[patch.around[0] > 0 ? 0 : 1], false);
            }
        } else if (lengths[0] + lengths[1] > 0) {
            const std::size_t side = lengths[0] > 0 ? 0 : 1;
            sides.side[t] = side == 0 ? ShellSide::Outer : ShellSide::Inner;
            sides.turned[t] = sides.turned[patch.like[side]];
            sets.join(t, patch.like[side], false);
        }
    }
    takeOverIslands(surface, neighbours, sets, sides);
}

/// Marks parts as single if their edges are not those of a shell: a folded sheet has openings along
/// both of its layers.
void dropFolded(const Surface& surface, const EdgeTable& table, TwoSided& sets, Sides& sides) {
    const int count = static_cast<int>(sides.side.size());
    const Points3& V = surface.mesh.V;
    Openings openings = openingsOf(table, static_cast<int>(V.rows()), sides);
    std::vector<Edging> edgings(static_cast<std::size_t>(count));
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        const auto uses = table.usesOf(e);
        const double length = (V.row(table.edges(e, 0)) - V.row(table.edges(e, 1))).norm();
        std::array<bool, 4> has{};
        for (const int use : uses) {
            has[numberOf(sides.side[use / 3])] = true;
        }
        const bool isBetween = has[numberOf(ShellSide::Rim)] ||
                               (has[numberOf(ShellSide::Outer)] && has[numberOf(ShellSide::Inner)]);
        const bool isOpen = uses.size() == 1;
        const bool isShared = isOpen && openings.areShared(table.edges(e, 0));
        for (const int use : uses) {
            if (isSide(sides.side[use / 3])) {
                Edging& edging = edgings[sets.find(use / 3).root];
                edging.all += isBetween || isOpen ? length : 0;
                edging.shared += isShared ? length : 0;
            }
        }
    }
    for (int t = 0; t < count; ++t) {
        if (!edgings[sets.find(t).root].isShells()) {
            sides.side[t] = ShellSide::Single;
            sides.turned[t] = 0;
        }
    }
}

/// Maximum share of a shell's area that is opposite itself.
constexpr double kMaxConflicts = 0.05;
/// Minimum ratio of the areas of the two surfaces.
constexpr double kMinBalance = 0.6;
/// Maximum thickness, relative to the root of one surface's area. Buttons are thicker.
constexpr double kThickestPart = 0.15;

/// A relation between triangles; the most certain ones come first.
struct Link {
    double doubt;
    int a, b;
    bool areApart;
};

TwoSided twoSidesOf(const Pairs& pairs, const std::vector<Neighbours>& neighbours) {
    std::vector<Link> links;
    for (const Neighbours& pair : neighbours) {
        if (pairs.opposite[pair.a] >= 0 && pairs.opposite[pair.b] >= 0) {
            links.push_back({pair.bend, pair.a, pair.b, false});
        }
    }
    const int count = static_cast<int>(pairs.opposite.size());
    for (int t = 0; t < count; ++t) {
        if (pairs.opposite[t] >= 0 && pairs.opposite[pairs.opposite[t]] >= 0) {
            links.push_back({kSmooth, t, pairs.opposite[t], true});
        }
    }
    std::stable_sort(links.begin(), links.end(),
                     [](const Link& a, const Link& b) { return a.doubt < b.doubt; });
    TwoSided sides(count);
    for (const Link& link : links) {
        sides.join(link.a, link.b, link.areApart);
    }
    return sides;
}

/// Sums over one shell that decide about it.
struct Sums {
    std::array<double, 2> area{}, facing{};
    double outwards = 0;  ///< positive if its first side is the outer one
    double volume = 0;    ///< of the cloth, from both sides: twice the true volume
    double conflicts = 0;

    bool isShell() const {
        const auto [least, most] = std::minmax(area[0], area[1]);
        const double both = area[0] + area[1];
        return least > 0 && least >= kMinBalance * most && conflicts <= kMaxConflicts * both &&
               volume <= kThickestPart * std::sqrt(most) * both;
    }
};

Eigen::Vector3d middleOf(const MeshArrays& mesh, int triangle) {
    return (mesh.V.row(mesh.F(triangle, 0)) + mesh.V.row(mesh.F(triangle, 1)) +
            mesh.V.row(mesh.F(triangle, 2)))
               .transpose() /
           3;
}

}  // namespace

Sides findSides(const Surface& surface, const Pairs& pairs) {
    const int count = static_cast<int>(pairs.opposite.size());
    const EdgeTable table = buildEdgeTable(surface.mesh.F, static_cast<int>(surface.mesh.V.rows()));
    const std::vector<Neighbours> neighbours = neighboursOf(surface, table);
    TwoSided sets = twoSidesOf(pairs, neighbours);
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (int t = 0; t < count; ++t) {
        centre += surface.area[t] * middleOf(surface.mesh, t);
    }
    centre /= surface.area.sum();

    std::vector<Sums> sums(static_cast<std::size_t>(count));
    for (int t = 0; t < count; ++t) {
        if (pairs.opposite[t] < 0) {
            continue;
        }
        const auto [root, isFlipped] = sets.find(t);
        const auto opposite = sets.find(pairs.opposite[t]);
        const std::size_t side = isFlipped ? 1 : 0;
        const double area = surface.area[t];
        const Eigen::Vector3d across = pairs.across.row(t).normalized();
        Sums& shell = sums[root];
        shell.area[side] += area;
        shell.volume += area * pairs.thickness[t];
        shell.facing[side] += area * across.dot(surface.normal.row(t));
        shell.outwards -=
            (side == 0 ? 1 : -1) * area * across.dot(middleOf(surface.mesh, t) - centre);
        shell.conflicts += opposite.root == root && opposite.isFlipped == isFlipped ? area : 0;
    }
    Sides sides{std::vector(static_cast<std::size_t>(count), ShellSide::Single),
                std::vector<char>(static_cast<std::size_t>(count), 0)};
    double volume = 0, area = 0;
    for (int t = 0; t < count; ++t) {
        const auto [root, isFlipped] = sets.find(t);
        const Sums& shell = sums[root];
        if (pairs.opposite[t] < 0 || !shell.isShell()) {
            continue;
        }
        const bool isOuter = (shell.outwards >= 0) == !isFlipped;
        const double facing = shell.facing[isFlipped ? 1 : 0];
        sides.side[t] = isOuter ? ShellSide::Outer : ShellSide::Inner;
        sides.turned[t] = (isOuter ? facing > 0 : facing < 0) ? 1 : 0;
        area += surface.area[t];
        volume += surface.area[t] * pairs.thickness[t];
    }
    fillIn(surface, pairs, neighbours, area > 0 ? volume / area : 0, sets, sides);
    dropFolded(surface, table, sets, sides);
    return sides;
}

}  // namespace toile::shell

namespace toile {
namespace {

/// The role of a face of the file, by most of its area, and its winding.
struct FaceSide {
    int face;
    ShellSide side;
    bool isTurned;
};

std::vector<FaceSide> faceSides(const FileSurface& surface, const Shell& shell) {
    std::vector<FaceSide> sides;
    const std::size_t count = surface.face.size();
    for (std::size_t first = 0; first < count;) {
        std::array<double, 4> areas{};
        double turned = 0;
        std::size_t t = first;
        for (; t < count && surface.face[t] == surface.face[first]; ++t) {
            const double area = doubleAreaNormal(surface.mesh, static_cast<Eigen::Index>(t)).norm();
            areas[static_cast<std::size_t>(shell.side[t])] += area;
            turned += shell.turned[t] != 0 ? area : -area;
        }
        const auto most = std::max_element(areas.begin(), areas.end()) - areas.begin();
        sides.push_back({surface.face[first], static_cast<ShellSide>(most), turned > 0});
        first = t;
    }
    return sides;
}

ShellSide sideOf(ShellSurface which) {
    return which == ShellSurface::Inner ? ShellSide::Inner : ShellSide::Outer;
}

/// Millimetres per unit of the soup.
double millimetresOf(const PolygonSoup& soup, const FileSurface& surface) {
    double inFile = 0, inMillimetres = 0;
    for (std::size_t v = 0; v < soup.positions.size(); ++v) {
        if (soup.positions[v].allFinite()) {
            inFile += soup.positions[v].lpNorm<1>();
            inMillimetres += surface.mesh.V.row(static_cast<Eigen::Index>(v)).lpNorm<1>();
        }
    }
    return inFile > 0 ? inMillimetres / inFile : 1;
}

/// The vector of each vertex of the outer surface to the middle, mm; equal for coinciding ones.
Points3 waysToMiddle(const FileSurface& surface, const Shell& shell) {
    const MeshArrays& mesh = surface.mesh;
    Points3 way = Points3::Zero(mesh.V.rows(), 3);
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(mesh.V.rows());
    const std::vector<int> target =
        findWeld(mesh.F, mesh.V, {.tolerance = 0, .borderOnly = false}).target;
    for (Eigen::Index t = 0; t < mesh.F.rows(); ++t) {
        const auto at = static_cast<std::size_t>(t);
        if (shell.side[at] != ShellSide::Outer) {
            continue;
        }
        const Eigen::RowVector3d normal = doubleAreaNormal(mesh, t).transpose();
        const double area = normal.norm();
        const double thickness = shell.thickness[at] > 0 ? shell.thickness[at] : shell.median;
        for (const int v : mesh.F.row(t)) {
            const int partner = shell.partner[v];
            if (partner >= 0) {
                way.row(target[v]) += area / 2 * (mesh.V.row(partner) - mesh.V.row(v));
            } else {
                way.row(target[v]) += (shell.turned[at] != 0 ? 0.5 : -0.5) * thickness * normal;
            }
            weight[target[v]] += area;
        }
    }
    for (Eigen::Index v = 0; v < way.rows(); ++v) {
        way.row(v) /= weight[v] > 0 ? weight[v] : 1;
    }
    for (Eigen::Index v = 0; v < way.rows(); ++v) {
        way.row(v) = Eigen::RowVector3d(way.row(target[static_cast<std::size_t>(v)]));
    }
    return way;
}

void moveToMiddle(PolygonSoup& sheet, const FileSurface& surface, const Shell& shell) {
    const double millimetres = millimetresOf(sheet, surface);
    const Points3 way = waysToMiddle(surface, shell);
    for (std::size_t v = 0; v < sheet.positions.size(); ++v) {
        const Eigen::Vector3d step = way.row(static_cast<Eigen::Index>(v)).transpose();
        if (!step.isZero(0)) {
            sheet.positions[v] += step / millimetres;
            if (!sheet.positionText.empty()) {
                sheet.positionText[v] = {};  // not the file's digits any more
            }
        }
    }
}

/// Reverses a face, keeping its first corner.
void turn(PolygonSoup& soup, int face) {
    const auto reverse = [&soup, face](std::vector<int>& perCorner) {
        if (!perCorner.empty()) {
            std::reverse(perCorner.begin() + soup.faceStart[face] + 1,
                         perCorner.begin() + soup.faceStart[face + 1]);
        }
    };
    reverse(soup.corners);
    reverse(soup.cornerUvs);
}

}  // namespace

PolygonSoup sheetOf(const PolygonSoup& soup, const FileSurface& surface, const Shell& shell,
                    ShellSurface which) {
    std::vector<int> kept;
    std::vector<char> isTurned;
    for (const FaceSide& face : faceSides(surface, shell)) {
        if (face.side == sideOf(which) || face.side == ShellSide::Single) {
            kept.push_back(face.face);
            isTurned.push_back(face.isTurned ? 1 : 0);
        }
    }
    PolygonSoup sheet = withFaces(soup, kept);
    for (int face = 0; face < sheet.faceCount(); ++face) {
        if (isTurned[static_cast<std::size_t>(face)] != 0) {
            turn(sheet, face);
        }
    }
    if (which == ShellSurface::Middle) {
        moveToMiddle(sheet, surface, shell);
    }
    return sheet;
}

LeftOut leftOut(const FileSurface& surface, const Shell& shell, ShellSurface which) {
    LeftOut left;
    for (const FaceSide& face : faceSides(surface, shell)) {
        if (face.side == ShellSide::Rim) {
            left.rims.push_back(face.face);
        } else if (face.side != sideOf(which) && face.side != ShellSide::Single) {
            left.other.push_back(face.face);
        }
    }
    return left;
}

}  // namespace toile
