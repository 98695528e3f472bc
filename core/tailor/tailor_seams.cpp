// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/tailor_seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "core/geometry/disjoint_sets.h"
#include "core/geometry/segment.h"
#include "core/tailor/form_lines.h"
#include "core/tailor/seam_pull.h"

namespace toile::tailor {
namespace {

/// Lines of trousers, each a path of vertices; of pairs first the one with negative `across`.
struct LegSeams {
    std::vector<int> centre;  ///< from the front of the waist between the legs to its back
    std::array<std::vector<int>, 2> inseam;  ///< from the crotch, a vertex of `centre`, to an ankle
    std::array<std::vector<int>, 2> side;    ///< from the waist to an ankle
};

/// A line at this distance from the mirror plane, mm, costs twice the base cost of its length.
constexpr double kOffCentre = 15, kCentreCost = 0.1;
/// Half-width of the waist's part where the centre line may end, as a fraction of its width.
constexpr double kWaistMiddle = 0.15;

template <class Keep>
std::vector<int> those(const std::vector<int>& vertices, const Keep& keep) {
    std::vector<int> kept;
    std::ranges::copy_if(vertices, std::back_inserter(kept), keep);
    return kept;
}

double widthOf(const BodyWays& ways, const std::vector<int>& rim) {
    const auto [least, most] =
        std::ranges::minmax(rim, {}, [&ways](int v) { return ways.across(v); });
    return ways.across(most) - ways.across(least);
}

std::optional<LegSeams> legSeams(const BodyWays& ways, const SeamPull& pull) {
    const GarmentBody& body = ways.body();
    const BodyOpening* waist = body.find(OpeningKind::Waist);
    const auto ankles = body.pair(OpeningKind::Ankle);
    if (!waist || !ankles) {
        return std::nullopt;
    }
    const std::vector<int>& rim = waist->loop.vertices;
    const double reach = kWaistMiddle * widthOf(ways, rim);
    const auto middle = [&](bool isFront) {
        return those(rim, [&](int v) {
            const double ahead = body.forward.dot(ways.at(v) - waist->centre);
            return std::abs(ways.across(v)) < reach && (isFront ? ahead > 0 : ahead < 0);
        });
    };
    const auto plane = ways.costs([&](int v) {
        const double off = ways.across(v) / kOffCentre;
        return kCentreCost + off * off;
    });
    LegSeams seams;
    seams.centre = pull.pulled(ways.cheapest(plane, middle(true), middle(false)), plane,
                               middle(true), middle(false));
    if (seams.centre.size() < 3) {
        return std::nullopt;
    }
    const int crotch =
        *std::ranges::min_element(seams.centre, {}, [&ways](int v) { return ways.height(v); });
    for (int k = 0; k < 2; ++k) {
        const int side = k == 0 ? -1 : 1;
        const BodyOpening& ankle = *(*ankles)[k];
        const double centre = body.across(ankle.centre);
        const auto half = [&](const std::vector<int>& vertices, double x, bool isOuter) {
            return those(vertices, [&](int v) {
                const double outward = side * (ways.across(v) - x);
                return isOuter ? outward > 0 : outward < 0;
            });
        };
        const std::vector<int> inner = half(ankle.loop.vertices, centre, false);
        const std::vector<int> outer = half(ankle.loop.vertices, centre, true);
        const std::vector<int> top = half(rim, side * reach, true);
        const std::vector<double>& costs = ways.silhouette();
        seams.inseam[k] =
            pull.pulled(ways.cheapest(costs, {crotch}, inner), costs, {crotch}, inner);
        seams.side[k] = pull.pulled(ways.cheapest(costs, top, outer), costs, top, outer);
    }
    return seams;
}

/// The two lines of a skirt from the waist to the hem, where it is widest.
std::array<std::vector<int>, 2> skirtSides(const BodyWays& ways, const SeamPull& pull) {
    const BodyOpening* waist = ways.body().find(OpeningKind::Waist);
    const BodyOpening* hem = ways.body().find(OpeningKind::Hem);
    std::array<std::vector<int>, 2> sides;
    if (!waist || !hem) {
        return sides;
    }
    const std::vector<double> costs = ways.envelope();
    for (int k = 0; k < 2; ++k) {
        const auto onSide = [&](int v) { return k == 0 ? ways.across(v) < 0 : ways.across(v) > 0; };
        const std::vector<int> from = those(waist->loop.vertices, onSide);
        const std::vector<int> to = those(hem->loop.vertices, onSide);
        sides[k] = pull.pulled(ways.cheapest(costs, from, to), costs, from, to);
    }
    return sides;
}

/// A line at this distance from its plane or height, mm, costs twice; base cost per length.
constexpr double kOffPlane = 15, kLength = 0.1;
constexpr double kOtherHalf = 1e4;
/// A garment has a waist if it is narrower than this fraction of its greatest width.
constexpr double kNarrow = 0.9;
constexpr int kHeights = 40;
/// Largest distance, mm, from there to a likely line of the mesh for the waist.
constexpr double kWaistReach = 50;
/// No waist is added if a cut crosses both sides within this distance, mm.
constexpr double kCutAround = 120;

/// Costs in one half of the garment, lowest where `off` is 0.
std::vector<double> costsNear(const BodyWays& ways, bool isFront,
                              const std::function<double(int)>& off) {
    return ways.costs([&](int v) {
        const double facing = isFront ? ways.facing(v) : -ways.facing(v);
        const double far = off(v) / kOffPlane;
        return facing < 0 ? kOtherHalf : kLength + far * far;
    });
}

/// The vertex of a way nearest to a height.
int vertexAt(const BodyWays& ways, const std::vector<int>& way, double height) {
    return *std::ranges::min_element(way, {},
                                     [&](int v) { return std::abs(ways.height(v) - height); });
}

/// Vertices of a way near a height, added to `nearest`.
std::vector<int> nearHeight(const BodyWays& ways, const std::vector<int>& way, double height,
                            std::vector<int> nearest) {
    std::ranges::copy_if(way, std::back_inserter(nearest), [&](int v) {
        return std::abs(ways.height(v) - height) < kWaistReach && v != nearest.front();
    });
    return nearest;
}

/// The line in the mirror plane from one rim to another, in the front or in the back: where the
/// mesh has the likelier one, else in the back.
std::vector<int> centreLine(const BodyWays& ways, const SeamPull& pull,
                            const std::vector<int>& from, const std::vector<int>& to) {
    std::vector<int> best;
    double likeliest = -1;
    for (const bool isFront : {false, true}) {
        const auto costs = costsNear(ways, isFront, [&](int v) { return ways.across(v); });
        const std::vector<int> way = pull.pulled(ways.cheapest(costs, from, to), costs, from, to);
        const double likeliness = pull.along(way);
        if (!way.empty() && likeliness > likeliest) {
            likeliest = likeliness;
            best = way;
        }
    }
    return best;
}

/// The line around the narrowest height of a trunk, from one side line to the other through the
/// front and back again; empty if the trunk is nearly as narrow everywhere, or if the user has cut
/// around it.
/// @param sides  from below the arms to the hem
std::vector<int> waistLine(const BodyWays& ways, const SeamPull& pull,
                           const std::array<std::vector<int>, 2>& sides) {
    double least = -std::numeric_limits<double>::infinity(), most = -least;
    for (const std::vector<int>& side : sides) {
        least = std::max(least, ways.height(side.back()));
        most = std::min(most, ways.height(side.front()));
    }
    double widest = 0, narrowest = std::numeric_limits<double>::infinity(), at = 0;
    for (int k = 1; k < kHeights; ++k) {
        const double height = least + k * (most - least) / kHeights;
        const double width = ways.across(vertexAt(ways, sides[1], height)) -
                             ways.across(vertexAt(ways, sides[0], height));
        widest = std::max(widest, width);
        if (width < narrowest) {
            narrowest = width;
            at = height;
        }
    }
    const auto isCutAround = [&](const std::vector<int>& side) {
        return std::ranges::any_of(side, [&](int v) {
            return pull.isAtSure(v) && std::abs(ways.height(v) - at) < kCutAround;
        });
    };
    if (least >= most || narrowest > kNarrow * widest || std::ranges::all_of(sides, isCutAround)) {
        return {};
    }
    std::vector<int> left{vertexAt(ways, sides[0], at)}, right{vertexAt(ways, sides[1], at)};
    std::vector<int> around;
    for (const bool isFront : {true, false}) {
        const auto costs = costsNear(ways, isFront, [&](int v) { return ways.height(v) - at; });
        std::vector<int> half = ways.cheapest(costs, left, right);
        // The first half fixes the ends of a line of the mesh, the second closes it.
        std::vector<int> led = isFront
                                   ? pull.pulled(half, costs, nearHeight(ways, sides[0], at, left),
                                                 nearHeight(ways, sides[1], at, right))
                                   : pull.pulled(half, costs, left, right);
        if (!isFront || pull.along(led) > MeshLines::kLikely) {
            half = std::move(led);
        }
        if (half.empty()) {
            return {};
        }
        left = {half.front()};
        right = {half.back()};
        if (!isFront) {
            std::ranges::reverse(half);
        }
        around.insert(around.end(), half.begin() + (isFront ? 0 : 1), half.end());
    }
    return around;
}

/// Width limits of a band, mm, and the share of its rim that it must cover.
constexpr double kNarrowest = 15, kWidest = 65, kAllRound = 0.85;
constexpr std::size_t kFewVertices = 3;

/// Distance from a vertex to a line of vertices, mm.
double distanceToLine(const BodyWays& ways, int vertex, const std::vector<int>& line) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < line.size(); ++k) {
        least = std::min(least, geometry::distanceToSegment(ways.at(vertex), ways.at(line[k - 1]),
                                                            ways.at(line[k])));
    }
    return least;
}

/// Finds lines that bound bands, as of a neck, a cuff or a waist: the whole line runs 15 to 65 mm
/// from the rim of an opening, and such lines cover nearly all of that rim.
/// @param ways  of vertices
/// @return per line
/// Cost: for each line and opening the product of their vertices. Pure.
std::vector<char> bandsAmong(const BodyWays& body, const std::vector<std::vector<int>>& ways) {
    std::vector<char> isBand(ways.size(), 0);
    for (const BodyOpening& opening : body.body().openings) {
        std::vector<int> rim = opening.loop.vertices;
        if (rim.empty()) {
            continue;
        }
        rim.push_back(rim.front());
        std::vector<std::size_t> beside;
        for (std::size_t w = 0; w < ways.size(); ++w) {
            if (std::ranges::all_of(ways[w], [&](int v) {
                    const double far = distanceToLine(body, v, rim);
                    return far > kNarrowest && far < kWidest;
                })) {
                beside.push_back(w);
            }
        }
        double covered = 0;
        for (std::size_t k = 1; k < rim.size(); ++k) {
            const bool isCovered = std::ranges::any_of(beside, [&](std::size_t w) {
                return distanceToLine(body, rim[k], ways[w]) < kWidest;
            });
            covered += isCovered ? (body.at(rim[k]) - body.at(rim[k - 1])).norm() : 0;
        }
        for (const std::size_t w : beside) {
            isBand[w] = isBand[w] != 0 || covered > kAllRound * opening.loop.perimeter ? 1 : 0;
        }
    }
    return isBand;
}

/// The same lines, with zero likeliness for those that bound bands: an armhole must not be pulled
/// to the border of a neck band. Cost: as above, for the likely lines.
MeshLines withoutBands(const BodyWays& body, MeshLines lines) {
    std::vector<std::size_t> likely;
    std::vector<std::vector<int>> ways;
    for (std::size_t line = 0; line < lines.ways.size(); ++line) {
        if (lines.likeliness[line] > MeshLines::kLikely && lines.ways[line].size() > kFewVertices) {
            likely.push_back(line);
            ways.push_back(lines.ways[line]);
        }
    }
    const std::vector<char> isBand = bandsAmong(body, ways);
    for (std::size_t k = 0; k < likely.size(); ++k) {
        lines.likeliness[likely[k]] *= isBand[k] != 0 ? 0 : 1;
    }
    return lines;
}

/// The stretches of a path along edges after some edges are left out. A closed path then starts at
/// such an edge; it stays whole if it has none. @param isLeftOut  tests an edge
template <class IsLeftOut>
std::vector<std::vector<int>> stretchesOf(std::vector<int> way, const IsLeftOut& isLeftOut) {
    const bool isRound = way.size() > 2 && way.front() == way.back();
    for (std::size_t k = 1; isRound && k < way.size(); ++k) {
        if (isLeftOut(way[k - 1], way[k])) {
            std::vector<int> turned(way.begin() + static_cast<std::ptrdiff_t>(k), way.end());
            turned.insert(turned.end(), way.begin() + 1,
                          way.begin() + static_cast<std::ptrdiff_t>(k) + 1);
            way = std::move(turned);
            break;
        }
    }
    std::vector<std::vector<int>> stretches;
    bool isOpen = false;
    for (std::size_t k = 1; k < way.size(); ++k) {
        const bool isOut = isLeftOut(way[k - 1], way[k]);
        if (!isOut && !isOpen) {
            stretches.push_back({way[k - 1]});
        }
        if (!isOut) {
            stretches.back().push_back(way[k]);
        }
        isOpen = !isOut;
    }
    return stretches;
}

/// Parts smaller than this are scraps, mm2.
constexpr double kScrapArea = 600;

constexpr int kUncut = -1, kCutAnyhow = -2;

class Scraps {
public:
    Scraps(const BodyWays& ways, const std::vector<TailorSeam>& seams,
           const std::vector<std::vector<int>>& cuts)
        : links_(ways.links()),
          seams_(seams),
          seamOf_(static_cast<std::size_t>(links_.edgeCount()), kUncut),
          parts_(links_.faceCount()) {
        for (std::size_t s = 0; s < seams.size(); ++s) {
            mark(seams[s].way, static_cast<int>(s));
        }
        for (const std::vector<int>& cut : cuts) {
            mark(cut, kCutAnyhow);
        }
    }

    std::vector<TailorSeam> run() {
        for (int e = 0; e < links_.edgeCount(); ++e) {
            if (seamOf_[e] == kUncut) {
                join(e);
            }
        }
        while (joinScraps()) {
        }
        std::vector<TailorSeam> left;
        for (const TailorSeam& seam : seams_) {
            const auto isLeftOut = [this](int from, int to) {
                return seamOf_[findEdge(links_.table().edges, from, to)] < 0;
            };
            for (std::vector<int>& way : stretchesOf(seam.way, isLeftOut)) {
                left.push_back({seam.line, seam.side, std::move(way), seam.likeliness});
            }
        }
        return left;
    }

private:
    void mark(const std::vector<int>& way, int seam) {
        for (std::size_t k = 1; k < way.size(); ++k) {
            seamOf_[findEdge(links_.table().edges, way[k - 1], way[k])] = seam;
        }
    }

    /// The triangles at an edge; the second is -1 at a rim.
    std::pair<int, int> facesAt(int edge) const {
        const auto uses = links_.table().usesOf(edge);
        return {uses[0] / 3, uses.size() == 2 ? uses[1] / 3 : -1};
    }

    void join(int edge) {
        const auto [one, other] = facesAt(edge);
        if (other >= 0) {
            parts_.join(one, other);
        }
    }

    /// The edges of a line between a part and its neighbour.
    struct Border {
        double length = 0;
        std::vector<int> edges;
    };

    /// Joins each scrap to the neighbour with which it shares most of a proposed line. Edges whose
    /// sides are one part by then are skipped. False if there are no scraps.
    bool joinScraps() {
        std::vector<double> areas(static_cast<std::size_t>(links_.faceCount()), 0);
        for (int f = 0; f < links_.faceCount(); ++f) {
            areas[parts_.root(f)] += doubleAreaNormal(links_.mesh(), f).norm() / 2;
        }
        std::map<int, std::map<std::pair<int, int>, Border>> borders;  // by scrap
        for (int e = 0; e < links_.edgeCount(); ++e) {
            const auto [one, other] = facesAt(e);
            if (seamOf_[e] < 0 || other < 0) {
                continue;
            }
            const int a = parts_.root(one), b = parts_.root(other);
            for (const auto& [scrap, neighbour] : {std::pair(a, b), std::pair(b, a)}) {
                if (a != b && areas[scrap] < kScrapArea) {
                    Border& border = borders[scrap][{neighbour, seamOf_[e]}];
                    border.length += lengthOf(e);
                    border.edges.push_back(e);
                }
            }
        }
        for (const auto& [scrap, around] : borders) {
            const auto most = std::ranges::max_element(
                around, {}, [](const auto& one) { return one.second.length; });
            for (const int e : most->second.edges) {
                const auto [one, other] = facesAt(e);
                if (parts_.root(one) != parts_.root(other)) {
                    seamOf_[e] = kUncut;
                }
            }
            for (const int e : most->second.edges) {
                if (seamOf_[e] == kUncut) {
                    join(e);
                }
            }
        }
        return !borders.empty();
    }

    double lengthOf(int edge) const {
        const auto ends = links_.table().edges.row(edge);
        return (links_.mesh().V.row(ends[1]) - links_.mesh().V.row(ends[0])).norm();
    }

    const SurfaceLinks& links_;
    const std::vector<TailorSeam>& seams_;
    std::vector<int> seamOf_;  ///< per edge: the seam that cuts it, or kUncut, or kCutAnyhow
    geometry::DisjointSets parts_;
};

/// Removes parts of proposed lines next to cuts made in any case: those along such cuts, and those
/// that would cut off a scrap of cloth, as where two lines meet a cut near its end.
/// @param cuts  paths of vertices, like those of the seams
/// @return the remaining seams; a seam may be split in several stretches
/// Cost: linear per round of joining scraps, usually one or two. Deterministic. Pure.
std::vector<TailorSeam> withoutScraps(const BodyWays& ways, const std::vector<TailorSeam>& seams,
                                      const std::vector<std::vector<int>>& cuts) {
    return Scraps(ways, seams, cuts).run();
}

}  // namespace
}  // namespace toile::tailor

namespace toile {
namespace {

class TailorSeams {
public:
    TailorSeams(const BodyWays& ways, const MeshLines& lines,
                const std::vector<std::vector<int>>& cuts)
        : ways_(ways),
          lines_(lines),
          unbanded_(tailor::withoutBands(ways, lines)),
          pull_(ways, unbanded_),
          cuts_(cuts) {}

    void addTop() {
        std::array<std::vector<int>, 2> sides;
        bool isSleeveless = false;
        for (const int side : {-1, 1}) {
            const auto top = tailor::topSide(ways_, pull_, side);
            if (!top) {
                continue;
            }
            const auto armpit = static_cast<std::ptrdiff_t>(top->armpit);
            const auto shoulder = static_cast<std::ptrdiff_t>(top->shoulder);
            isSleeveless = isSleeveless || !top->hasSleeve;
            sides[side < 0 ? 0 : 1].assign(top->under.begin() + armpit, top->under.end());
            add(TailorLine::Side, side, sides[side < 0 ? 0 : 1]);
            add(TailorLine::Shoulder, side,
                {top->ridge.begin(), top->ridge.begin() + shoulder + 1});
            if (top->hasSleeve) {
                add(TailorLine::Underarm, side,
                    {top->under.begin(), top->under.begin() + armpit + 1});
                add(TailorLine::Armhole, side, top->armhole);
            }
        }
        if (isSleeveless && !sides[0].empty() && !sides[1].empty()) {
            const GarmentBody& body = ways_.body();
            add(TailorLine::Centre, 0,
                tailor::centreLine(ways_, pull_, body.find(OpeningKind::Neck)->loop.vertices,
                                   body.find(OpeningKind::Hem)->loop.vertices));
            add(TailorLine::Waist, 0, tailor::waistLine(ways_, pull_, sides));
        }
    }

    void addLegs() {
        if (const auto legs = tailor::legSeams(ways_, pull_)) {
            add(TailorLine::Centre, 0, legs->centre);
            for (int k = 0; k < 2; ++k) {
                add(TailorLine::Inseam, 2 * k - 1, legs->inseam[k]);
                add(TailorLine::Side, 2 * k - 1, legs->side[k]);
            }
        }
    }

    void addSkirt() {
        const auto sides = tailor::skirtSides(ways_, pull_);
        add(TailorLine::Side, -1, sides[0]);
        add(TailorLine::Side, 1, sides[1]);
    }

    void addStyleLines() {
        std::vector<std::vector<int>> known = cuts_;
        for (const TailorSeam& seam : seams_) {
            known.push_back(seam.way);
        }
        const tailor::SeamPull pull(ways_, lines_);
        std::vector<std::vector<int>> found = tailor::styleLines(ways_, lines_, pull, known);
        const std::vector<char> isBand = tailor::bandsAmong(ways_, found);
        for (std::size_t k = 0; k < found.size(); ++k) {
            add(isBand[k] != 0 ? TailorLine::Band : TailorLine::Style, 0, std::move(found[k]));
        }
    }

    /// Removes the parts along the cuts.
    void leaveOutCuts() {
        const std::vector<TailorSeam> left = tailor::withoutScraps(ways_, seams_, cuts_);
        seams_.clear();
        for (const TailorSeam& seam : left) {
            add(seam.line, seam.side, seam.way);
        }
    }

    std::vector<TailorSeam> take() { return std::move(seams_); }

private:
    void add(TailorLine line, int side, std::vector<int> way) {
        if (way.size() > 1) {
            const double likeliness = tailor::alongLines(ways_, lines_, way);
            seams_.push_back({line, side, std::move(way), likeliness});
        }
    }

    const BodyWays& ways_;
    const MeshLines& lines_;
    const MeshLines unbanded_;
    const tailor::SeamPull pull_;  ///< not to bands
    const std::vector<std::vector<int>>& cuts_;
    std::vector<TailorSeam> seams_;
};

}  // namespace

std::vector<TailorSeam> tailorSeams(const BodyWays& ways, const MeshLines& lines,
                                    const std::vector<std::vector<int>>& cuts,
                                    const Progress& progress) {
    TailorSeams seams(ways, lines, cuts);
    switch (ways.body().form) {
        case BodyForm::Top:
            seams.addTop();
            break;
        case BodyForm::Trousers:
            seams.addLegs();
            break;
        case BodyForm::Skirt:
            seams.addSkirt();
            break;
        case BodyForm::Unknown:
            break;
    }
    if (!progress.isCancelled()) {
        seams.addStyleLines();
    }
    if (!cuts.empty()) {
        seams.leaveOutCuts();
    }
    return seams.take();
}

}  // namespace toile
