// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/edge_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "core/geometry/disjoint_sets.h"

namespace toile {
namespace {

using Eigen::Vector3d;

constexpr double kShortestOpening = 80;  // mm
/// An edge is at the top or bottom of cloth if its direction out of the cloth has this component.
constexpr double kUpright = 0.5;
/// An edge runs along an axis if its direction has this component.
constexpr double kSteep = 0.75;
/// An opening from below the first height in the cloth, of 0 to 1, to above the second is an open
/// front. Above the second, edges that face down are those of fallen collars and hoods, not hems.
constexpr double kLow = 0.4, kHigh = 0.7;
/// Parts much shorter than this, mm, or than this share of an opening belong to their neighbours.
constexpr double kShortPart = 25, kShortShare = 0.03;
/// Two upright edges face each other if their distance is below this share of the way along the
/// opening between them.
constexpr double kFacing = 0.3;
/// Openings of a pair: ratio of their lengths; differences of height and of distances from the
/// middle as shares of their length.
constexpr double kPairLength = 0.6, kPairHeight = 0.35;
/// Distance of an arm's opening from the neck as a share of its length: armholes are nearer than
/// the first, long sleeves farther than the second, or than `kLongReach`, mm.
constexpr double kArmhole = 0.45, kLongSleeve = 1.6, kLongReach = 550;
/// An unsewn panel with one rim, and any flat sheet, have mean normals longer than this.
constexpr double kLooksOneWay = 0.72, kFlat = 0.97;
/// The mean direction out of a hood is longer than the first, and its upward component is between
/// these shares of its length: a hood may lean back, the edge of a collar points down.
constexpr double kHoodClear = 0.3, kHoodDown = 0.4, kHoodUp = 0.75;

const Vector3d kUp(0, 1, 0);

double levelDistance(const Vector3d& a, const Vector3d& b) {
    return std::hypot(a.x() - b.x(), a.z() - b.z());
}

/// A free stretch of an outline, or an edge of one, in the order in which an opening is followed.
struct FreeEdge {
    int piece = -1, edge = 0;
    double from = 0, length = 0;  ///< from: way along the opening, mm
    Vector3d middle, along, out;  ///< unit; `out` leaves the cloth
    EdgeKind kind = EdgeKind::Unknown;
};

enum class Level { Top, Side, Bottom };

struct Opening {
    std::vector<FreeEdge> edges;
    double length = 0;                                                  ///< mm
    Vector3d centre{0, 0, 0}, out{0, 0, 0};                             ///< means
    double low = std::numeric_limits<double>::infinity(), high = -low;  ///< heights
    bool isPaired = false;

    double height() const { return centre.dot(kUp); }
    double radius() const { return length / (2 * std::numbers::pi); }

    void finish() {
        for (FreeEdge& edge : edges) {
            edge.from = length;
            length += edge.length;
            centre += edge.length * edge.middle;
            out += edge.length * edge.out;
            low = std::min(low, edge.middle.dot(kUp));
            high = std::max(high, edge.middle.dot(kUp));
        }
        centre /= std::max(length, 1e-12);
        out /= std::max(length, 1e-12);
    }
    void set(EdgeKind kind) {
        for (FreeEdge& edge : edges) {
            edge.kind = kind;
        }
    }
};

/// Follows free edges across the seams at their ends.
class OpeningTracer {
public:
    OpeningTracer(const SeamGraph& graph, const seam::Outlines& outlines)
        : outlines_(outlines), ways_(outlines.list.size()) {
        for (const Seam& seam : graph.seams) {
            const int left = outlines.indexOf(seam.left);
            const Place start{left, seam.left.start, seam.left.reversed ? -1 : 1};
            const Place end{left, seam.left.end, -start.onward};
            if (seam.kind == SeamKind::Free) {
                ways_[left].push_back({start, {left, end.at, 1}, static_cast<int>(free_.size())});
                ways_[left].push_back({end, {left, start.at, -1}, static_cast<int>(free_.size())});
                free_.push_back({seam.left.start, seam.left.end});
                starts_.push_back(start);
            } else if (seam.right.piece >= 0 && !seam.closed && !seam.stacked) {
                const int right = outlines.indexOf(seam.right);
                const int onward = seam.right.reversed ? -1 : 1;
                addWays(start, {right, seam.right.start, onward});
                addWays(end, {right, seam.right.end, -onward});
            }
        }
        isUsed_.resize(free_.size());
    }

    std::vector<Opening> run() {
        std::vector<Opening> found;
        for (std::size_t k = 0; k < free_.size(); ++k) {
            if (!isUsed_[k]) {
                found.push_back(trace(starts_[k]));
            }
        }
        return found;
    }

private:
    /// A place on an outline, and the direction in which something continues there.
    struct Place {
        int outline = -1;
        double at = 0;
        int onward = 1;
    };
    /// Along a free stretch to its other end, or across a seam to the end of its other side.
    struct Way {
        Place from, to;
        int free = -1;  ///< the stretch
    };

    void addWays(const Place& one, const Place& other) {
        ways_[one.outline].push_back({one, {other.outline, other.at, -other.onward}});
        ways_[other.outline].push_back({other, {one.outline, one.at, -one.onward}});
    }

    /// The way on from a place. Remainders between a seam and a free edge are short.
    const Way* wayFrom(const Place& place) const {
        const seam::Outline& outline = outlines_.list[place.outline];
        const Way* nearest = nullptr;
        double least = 1.5 * outline.spacingAt(place.at) + 1e-6;
        for (const Way& way : ways_[place.outline]) {
            const double apart = outline.line.apart(place.at, way.from.at);
            if (way.from.onward == place.onward && apart < least) {
                least = apart;
                nearest = &way;
            }
        }
        return nearest;
    }

    Opening trace(Place at) {
        constexpr int kMaxSeams = 64;  // that meet in a point
        Opening opening;
        for (int seams = 0; seams < kMaxSeams; ++seams) {
            const Way* way = wayFrom(at);
            if (!way || (way->free >= 0 && isUsed_[way->free])) {
                break;
            }
            if (way->free >= 0) {
                isUsed_[way->free] = true;
                addEdges(at, free_[way->free], opening);
                seams = 0;
            }
            at = way->to;
        }
        opening.finish();
        return opening;
    }

    void addEdges(const Place& at, const geometry::Interval& free, Opening& opening) const {
        const seam::Outline& line = outlines_.list[at.outline];
        const double turns = free.low - line.wrap(free.low);
        const std::size_t before = opening.edges.size();
        for (int k = line.edgeAt(free.low); turns + line.arcOf(k) < free.high - 1e-9; ++k) {
            const double low = std::max(free.low, turns + line.arcOf(k));
            const double high = std::min(free.high, turns + line.arcOf(k + 1));
            if (high - low > 1e-9) {
                const int edge = line.wrapIndex(k);
                opening.edges.push_back(
                    {at.outline, edge, 0, high - low, line.pointAt((low + high) / 2),
                     at.onward * (line.line.point(k + 1) - line.line.point(k)).normalized(),
                     -line.inward.row(edge).transpose()});
            }
        }
        if (at.onward < 0) {
            std::reverse(opening.edges.begin() + static_cast<std::ptrdiff_t>(before),
                         opening.edges.end());
        }
    }

    const seam::Outlines& outlines_;
    std::vector<std::vector<Way>> ways_;  ///< per outline
    std::vector<geometry::Interval> free_;
    std::vector<Place> starts_;  ///< of free stretches
    std::vector<bool> isUsed_;   ///< per free stretch
};

/// For each edge of an opening the level that most of the opening around it has.
template <class LevelOf>
std::vector<Level> smoothed(const Opening& opening, const LevelOf& levelOf) {
    const double reach = std::max(kShortPart, kShortShare * opening.length) / 2;
    const int n = static_cast<int>(opening.edges.size());
    std::vector<Level> own, smooth;
    std::ranges::transform(opening.edges, std::back_inserter(own), levelOf);
    for (int k = 0; k < n; ++k) {
        std::array<double, 3> lengths{};
        for (const int step : {1, -1}) {
            double way = 0;
            for (int i = 0; i < n && way < reach; ++i) {
                const int at = (k + step * i + n) % n;
                way += opening.edges[at].length;
                lengths[static_cast<std::size_t>(own[at])] += opening.edges[at].length;
            }
        }
        smooth.push_back(static_cast<Level>(std::ranges::max_element(lengths) - lengths.begin()));
    }
    return smooth;
}

/// Cloth that hangs together by seams.
struct Cloth {
    std::vector<Opening*> openings;
    double area = 0;                            ///< mm^2
    Vector3d centre{0, 0, 0}, normal{0, 0, 0};  ///< means
    Eigen::AlignedBox3d box;

    /// Height in the cloth, 0 to 1.
    double share(double height) const {
        return (height - box.min().y()) / std::max(box.sizes().y(), 1e-9);
    }
    double width() const { return std::max(box.sizes().x(), box.sizes().z()); }
};

class ClothReader {
public:
    ClothReader(Cloth& cloth, const Garment& garment, const seam::Outlines& outlines)
        : cloth_(cloth), garment_(garment), outlines_(outlines) {}

    void run() {
        std::erase_if(cloth_.openings, [](Opening* opening) {
            opening->set(opening->length < kShortestOpening ? EdgeKind::Slit : EdgeKind::Unknown);
            return opening->length < kShortestOpening;
        });
        if (cloth_.normal.norm() > (cloth_.openings.size() > 1 ? kFlat : kLooksOneWay)) {
            return;  // unsewn, or not worn
        }
        findPairs();
        sortOpenings();
        for (Opening* opening : middle_) {
            readMiddle(*opening);
        }
        for (Opening* arm : arms_) {
            readArm(*arm);
        }
        for (Opening* leg : legs_) {
            leg->set(EdgeKind::Hem);
            markFacing(*leg, leg->out, EdgeKind::Slit);
        }
        markCollars();
    }

private:
    Level levelOf(const FreeEdge& edge) const {
        const double up = edge.out.dot(kUp);
        return std::abs(up) <= kUpright   ? Level::Side
               : up > 0 || isFallen(edge) ? Level::Top
                                          : Level::Bottom;
    }
    bool isFallen(const FreeEdge& edge) const {
        return edge.out.dot(kUp) < -kUpright && cloth_.share(edge.middle.y()) > kHigh;
    }
    bool isOpenFront(const Opening& opening) const {
        return cloth_.share(opening.low) < kLow && cloth_.share(opening.high) > kHigh;
    }

    /// How far two openings are from being a pair; infinite if they are none.
    double pairError(const Opening& a, const Opening& b) const {
        const double mean = (a.length + b.length) / 2;
        const double apart = levelDistance(a.centre, b.centre);
        const double height = std::abs(a.height() - b.height());
        const double aside = levelDistance((a.centre + b.centre) / 2, cloth_.centre);
        const bool isPair =
            std::min(a.length, b.length) > kPairLength * std::max(a.length, b.length) &&
            height < kPairHeight * mean && aside < kPairHeight * apart &&
            apart > 0.7 * (a.radius() + b.radius());
        return isPair ? height + aside + std::abs(a.length - b.length) : HUGE_VAL;
    }

    void findPairs() {
        const auto partner = [this](const Opening* one) {
            return *std::ranges::min_element(cloth_.openings, {}, [&](const Opening* other) {
                return other == one ? HUGE_VAL : pairError(*one, *other);
            });
        };
        for (Opening* one : cloth_.openings) {
            const Opening* other = partner(one);
            one->isPaired =
                other != one && pairError(*one, *other) < HUGE_VAL && partner(other) == one;
        }
    }

    void sortOpenings() {
        std::vector<Opening*> pairs;
        double lowest = cloth_.centre.dot(kUp);  // of pairs
        for (Opening* opening : cloth_.openings) {
            const bool isMiddle = !opening->isPaired;
            (isMiddle ? middle_ : pairs).push_back(opening);
            lowest = isMiddle ? lowest : std::min(lowest, opening->height());
        }
        std::ranges::stable_sort(middle_, std::ranges::greater{}, &Opening::height);
        const bool hasHem = std::ranges::any_of(middle_, [this](const Opening* opening) {
            return isOpenFront(*opening) || !isTop(*opening);
        });
        for (Opening* opening : pairs) {
            const bool isLeg = !hasHem && opening->height() < cloth_.centre.dot(kUp) &&
                               opening->height() - lowest < kPairHeight * opening->length;
            (isLeg ? legs_ : arms_).push_back(opening);
        }
    }

    /// Whether the cloth of a middle opening is below it.
    bool isTop(const Opening& opening) const {
        const double share = cloth_.share(opening.height());
        const double up = opening.out.dot(kUp);
        const bool isHighest = cloth_.openings.size() > 1 && &opening == middle_.front();
        if (isHighest && share > 0.6) {
            return true;  // even if a collar falls over
        }
        return std::abs(up) > 0.15 ? up > 0 : share > 0.5;
    }

    EdgeKind topKind() const {
        return !arms_.empty()               ? EdgeKind::Neckline
               : cloth_.openings.size() > 1 ? EdgeKind::Waist
                                            : EdgeKind::Hem;
    }

    void readMiddle(Opening& opening) {
        if (isOpenFront(opening)) {
            readOpenFront(opening);
        } else if (isTop(opening)) {
            const double clear = opening.out.norm();
            const double up = opening.out.dot(kUp);
            const bool isHood = !arms_.empty() && clear > kHoodClear && up > -kHoodDown * clear &&
                                up < kHoodUp * clear;
            opening.set(isHood ? EdgeKind::Hem : topKind());
            markFacing(opening, kUp, EdgeKind::Front);
        } else {
            opening.set(EdgeKind::Hem);
            markFacing(opening, kUp, EdgeKind::Slit);
        }
    }

    void readOpenFront(Opening& opening) {
        const std::vector<Level> levels =
            smoothed(opening, [this](const FreeEdge& edge) { return levelOf(edge); });
        for (std::size_t k = 0; k < levels.size(); ++k) {
            opening.edges[k].kind = levels[k] == Level::Side     ? EdgeKind::Front
                                    : levels[k] == Level::Bottom ? EdgeKind::Hem
                                    : arms_.empty()              ? EdgeKind::Waist
                                                                 : EdgeKind::Neckline;
        }
    }

    /// Marks parts along an axis whose edges face each other across a narrow gap.
    static void markFacing(Opening& opening, const Vector3d& axis, EdgeKind kind) {
        const Vector3d onward = axis.normalized();
        std::vector<FreeEdge> steep;
        std::ranges::copy_if(opening.edges, std::back_inserter(steep), [&](const FreeEdge& edge) {
            return std::abs(edge.along.dot(onward)) > kSteep;
        });
        const auto isFacing = [&](const FreeEdge& edge) {
            return std::ranges::any_of(steep, [&](const FreeEdge& other) {
                const double way = std::abs(edge.from - other.from);
                return edge.along.dot(other.along) < 0 &&
                       (edge.middle - other.middle).norm() <
                           kFacing * std::min(way, opening.length - way);
            });
        };
        const std::vector<Level> levels = smoothed(opening, [&](const FreeEdge& edge) {
            const bool isSide = std::abs(edge.along.dot(onward)) > kSteep && isFacing(edge);
            return isSide ? Level::Side : Level::Top;
        });
        for (std::size_t k = 0; k < levels.size(); ++k) {
            FreeEdge& edge = opening.edges[k];
            edge.kind = levels[k] == Level::Side ? kind : edge.kind;
        }
    }

    void readArm(Opening& arm) {
        double nearest = HUGE_VAL;
        for (const Opening* opening : middle_) {
            for (const FreeEdge& neck : opening->edges) {
                if (neck.kind == EdgeKind::Neckline) {
                    for (const FreeEdge& edge : arm.edges) {
                        nearest = std::min(nearest, (edge.middle - neck.middle).squaredNorm());
                    }
                }
            }
        }
        nearest = std::sqrt(nearest);
        const bool isLong = nearest > std::min(kLongSleeve * arm.length, kLongReach);
        arm.set(nearest < kArmhole * arm.length ? EdgeKind::Armhole
                : isLong                        ? EdgeKind::Cuff
                                                : EdgeKind::Hem);
        markFacing(arm, arm.out, EdgeKind::Slit);
    }

    /// Free edges at the neck of narrow pieces that are sewn to others: collars, bands, plackets;
    /// and edges of collars that have fallen over.
    void markCollars() {
        constexpr double kWidest = 130, kWidestPlacket = 60, kBandShape = 0.45, kSewn = 0.3,
                         kAlong = 0.35, kMostlyFallen = 0.4;
        struct AtNeck {
            double length = 0, upright = 0, fallen = 0, free = 0;  ///< mm
            EdgeKind kind = EdgeKind::Neckline;
        };
        std::map<int, AtNeck> pieces;
        for (const Opening* opening : cloth_.openings) {
            for (const FreeEdge& edge : opening->edges) {
                AtNeck& at = pieces[edge.piece];
                const double neck = edge.kind == EdgeKind::Neckline ? edge.length : 0;
                at.free += edge.length;
                at.length += neck;
                at.fallen += isFallen(edge) ? neck : 0;
                at.upright += std::abs(edge.along.dot(kUp)) * neck;
            }
        }
        for (auto& [piece, at] : pieces) {
            // Sides of a rectangle of the same area and perimeter.
            const auto p = static_cast<std::size_t>(piece);
            const double perimeter = outlines_.list[p].length(), mean = perimeter / 4;
            const double half =
                std::sqrt(std::max(0.0, mean * mean - surfaceArea(garment_.pieces[p]->mesh)));
            const double width = mean - half;
            const bool isBand = width < std::min(kWidest, kBandShape * (mean + half)) &&
                                at.free < (1 - kSewn) * perimeter;
            const bool isAlong = at.length > kAlong * perimeter;
            if (isBand && (isAlong || width < kWidestPlacket) &&
                at.upright > (isAlong ? 0.6 : 0.4) * at.length) {
                at.kind = EdgeKind::Front;
            } else if (at.fallen > kMostlyFallen * at.length || (isBand && isAlong)) {
                at.kind = EdgeKind::Collar;
            }
        }
        for (Opening* opening : middle_) {
            for (FreeEdge& edge : opening->edges) {
                edge.kind = edge.kind == EdgeKind::Neckline ? pieces[edge.piece].kind : edge.kind;
            }
        }
    }

    Cloth& cloth_;
    const Garment& garment_;
    const seam::Outlines& outlines_;
    std::vector<Opening*> middle_, arms_, legs_;  ///< `middle_` from top to bottom
};

void addSurface(const MeshArrays& mesh, Cloth& cloth) {
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const Vector3d normal = doubleAreaNormal(mesh, f) / 2;
        const double area = normal.norm();
        const Vector3d middle =
            (mesh.V.row(mesh.F(f, 0)) + mesh.V.row(mesh.F(f, 1)) + mesh.V.row(mesh.F(f, 2))) / 3;
        cloth.area += area;
        cloth.normal += normal;
        cloth.centre += area * middle;
    }
    for (const auto& point : mesh.V.rowwise()) {
        cloth.box.extend(Vector3d(point.transpose()));
    }
}

}  // namespace

std::vector<std::vector<FoundEdge>> findEdgeKinds(const Garment& garment,
                                                  const seam::Outlines& outlines) {
    std::vector<std::vector<FoundEdge>> found(garment.pieces.size());
    for (std::size_t p = 0; p < found.size(); ++p) {
        found[p].resize(static_cast<std::size_t>(outlines.list[p].size()));
    }
    std::vector<Opening> openings = OpeningTracer(garment.seams, outlines).run();
    geometry::DisjointSets sets(static_cast<int>(garment.pieces.size()));
    for (const Seam& seam : garment.seams.seams) {
        if (seam.kind != SeamKind::Free && seam.right.piece >= 0) {
            sets.join(seam.left.piece, seam.right.piece);
        }
    }
    std::map<int, Cloth> cloths;
    for (std::size_t p = 0; p < found.size(); ++p) {
        addSurface(garment.pieces[p]->mesh, cloths[sets.root(static_cast<int>(p))]);
    }
    for (Opening& opening : openings) {
        if (!opening.edges.empty()) {
            cloths[sets.root(opening.edges.front().piece)].openings.push_back(&opening);
        }
    }
    for (auto& [set, cloth] : cloths) {
        cloth.centre /= std::max(cloth.area, 1e-12);
        cloth.normal /= std::max(cloth.area, 1e-12);
        ClothReader(cloth, garment, outlines).run();
    }
    for (std::size_t k = 0; k < openings.size(); ++k) {
        for (const FreeEdge& edge : openings[k].edges) {
            found[edge.piece][edge.edge] = {edge.kind, static_cast<int>(k)};
        }
    }
    return found;
}

}  // namespace toile
