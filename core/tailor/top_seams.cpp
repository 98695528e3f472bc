// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/geometry/segment.h"
#include "core/tailor/tailor_seams.h"

namespace toile::tailor {
namespace {

/// Depth of an armhole's curve towards the body, as a fraction of its height.
constexpr double kHollow = 0.16;
/// A line at this distance from its target, mm, costs double; multiple that limits the cost.
constexpr double kOff = 20, kMaxOff = 5, kLengthCost = 0.2;
/// Smallest `facing` of the half that a line may run through, and distance from the middle, mm.
constexpr double kHalfFacing = -0.35, kNearMiddle = 20;
constexpr double kForbidden = 1e4;
/// Largest moves of armpit and shoulder point, mm, to reach a line of the mesh; cost of a move.
constexpr double kArmpitReach = 50, kShoulderReach = 110, kShift = 0.15;
constexpr double kArmpitStep = 25;
/// From this likeliness on a line of the mesh is taken for the armhole seam.
constexpr double kArmholeSure = 0.45;

class ArmholeFinder {
public:
    ArmholeFinder(const BodyWays& ways, const SeamPull& pull, int side, TopSide& top)
        : ways_(ways), pull_(pull), side_(side), top_(top) {}

    void run() {
        const std::vector<std::size_t> armpits =
            within(top_.under, top_.armpit, kArmpitReach, kArmpitStep);
        const std::vector<std::size_t> shoulders =
            within(top_.ridge, top_.shoulder, kShoulderReach, 0);
        using Places = std::vector<std::size_t>;
        // The form alone fixes the armhole, unless there are cuts.
        take(bestArmhole(pull_.hasSure() ? armpits : Places{top_.armpit},
                         pull_.hasSure() ? shoulders : Places{top_.shoulder},
                         armholeCosts(true, false), armholeCosts(false, false)));
        Armhole led = bestArmhole(armpits, shoulders, pull_.eased(armholeCosts(true, true)),
                                  pull_.eased(armholeCosts(false, true)));
        if (pull_.along(led.way) > kArmholeSure) {
            take(std::move(led));
        }
    }

private:
    Eigen::Vector2d seen(int vertex) const { return ways_.seen(vertex, side_); }

    /// Costs of an armhole in the front or the back: low near its target curve, or anywhere if
    /// lines of the mesh may lead it.
    std::vector<double> armholeCosts(bool isFront, bool isLed) const {
        const Eigen::Vector2d from = seen(top_.under[top_.armpit]);
        const Eigen::Vector2d way = seen(top_.ridge[top_.shoulder]) - from;
        const Eigen::Vector2d inward(-way.y(), way.x());
        std::vector<Eigen::Vector2d> target;
        constexpr int kParts = 24;
        for (int k = 0; k <= kParts; ++k) {
            const double t = static_cast<double>(k) / kParts;
            target.push_back(from + t * way + kHollow * 4 * t * (1 - t) * inward);
        }
        std::vector<char> isOnRidge(static_cast<std::size_t>(ways_.links().vertexCount()), 0);
        for (const int v : top_.ridge) {  // of both halves, in any direction
            isOnRidge[v] = 1;
        }
        std::vector<double> costs = ways_.costs([&](int v) {
            const double facing = isFront ? ways_.facing(v) : -ways_.facing(v);
            if ((facing < kHalfFacing && isOnRidge[v] == 0) ||
                side_ * ways_.across(v) < kNearMiddle) {
                return kForbidden;
            }
            double off = isLed ? 0 : kOff * kMaxOff;
            for (std::size_t k = 1; !isLed && k < target.size(); ++k) {
                off = std::min(off, geometry::distanceToSegment(seen(v), target[k - 1], target[k]));
            }
            const double far = off / kOff;
            return kLengthCost + far * far;
        });
        return costs;
    }

    int edgeBetween(int from, int to) const {
        return findEdge(ways_.links().table().edges, from, to);
    }

    /// Costs that keep a line from running along the lines that it separates.
    std::vector<double> parting(std::vector<double> costs) const {
        for (const auto* line : {&top_.under, &top_.ridge}) {
            for (std::size_t k = 1; k < line->size(); ++k) {
                costs[edgeBetween((*line)[k - 1], (*line)[k])] *= kForbidden;
            }
        }
        return costs;
    }

    /// Half an armhole: from an armpit to each place of the ridge, straight or along a border of
    /// the file: the ridge follows it from that place on, where it leaves the shoulder line.
    struct Half {
        geometry::ShortestForest ways;
        std::vector<double> straight, along;  ///< costs, by place
        std::vector<std::size_t> meets;       ///< by place: where `along` reaches the ridge
    };

    Half halfFrom(std::size_t armpit, const std::vector<std::size_t>& shoulders,
                  const std::vector<double>& costs) const {
        const int low = top_.under[armpit];
        std::vector<double> parted = parting(costs);
        Half half;
        half.ways = ways_.waysFrom(
            low, pull_.hasSure() ? keptOff(std::move(parted), low, shoulders) : parted);
        half.meets.resize(top_.ridge.size());
        for (const int v : top_.ridge) {
            half.straight.push_back(half.ways.distance[v]);
        }
        half.along = half.straight;
        std::iota(half.meets.begin(), half.meets.end(), std::size_t{0});
        const std::vector<int>& ridge = top_.ridge;
        for (std::size_t k = 1; k + 1 < ridge.size(); ++k) {
            double cost = 0;
            const auto isAlong = [&](std::size_t next) {
                return pull_.goesOn(ridge[next - 2], ridge[next - 1], ridge[next]) ==
                           (next > k + 1) &&
                       pull_.isBorder(ridge[next - 1], ridge[next]);
            };
            for (std::size_t meets = k + 1; meets < ridge.size() && isAlong(meets); ++meets) {
                cost += costs[edgeBetween(ridge[meets - 1], ridge[meets])];
                if (cost + half.straight[meets] < half.along[k]) {
                    half.along[k] = cost + half.straight[meets];
                    half.meets[k] = meets;
                }
            }
        }
        return half;
    }

    std::vector<int> wayOf(const Half& half, std::size_t shoulder, bool isAlong) const {
        std::size_t k = isAlong ? half.meets[shoulder] : shoulder;
        std::vector<int> way = half.ways.pathTo(top_.ridge[k], ways_.links().table().edges);
        while (k > shoulder) {
            way.push_back(top_.ridge[--k]);
        }
        return way;
    }

    /// The best armhole from one of some armpits to one of some shoulder points.
    struct Armhole {
        std::vector<int> way;
        std::size_t armpit = 0, shoulder = 0;
        double cost = std::numeric_limits<double>::infinity();
    };

    Armhole bestArmhole(const std::vector<std::size_t>& armpits,
                        const std::vector<std::size_t>& shoulders, const std::vector<double>& front,
                        const std::vector<double>& back) const {
        Armhole best;
        for (const std::size_t armpit : armpits) {
            const Half ahead = halfFrom(armpit, shoulders, front);
            const Half behind = halfFrom(armpit, shoulders, back);
            for (const std::size_t shoulder : shoulders) {
                for (const bool isAheadAlong : {false, true}) {  // then the other half is straight
                    const std::size_t meets = (isAheadAlong ? ahead : behind).meets[shoulder];
                    const double cost =
                        (isAheadAlong ? ahead.along : ahead.straight)[shoulder] +
                        (isAheadAlong ? behind.straight : behind.along)[shoulder] +
                        kShift * (shiftOf(top_.under, top_.armpit, armpit) +
                                  shiftOf(top_.ridge, top_.shoulder,
                                          std::clamp(top_.shoulder, shoulder, meets)));
                    if (cost < best.cost) {
                        std::vector<int> way = wayOf(ahead, shoulder, isAheadAlong);
                        const std::vector<int> down = wayOf(behind, shoulder, !isAheadAlong);
                        way.insert(way.end(), down.rbegin() + 1, down.rend());
                        best = {std::move(way), armpit, shoulder, cost};
                    }
                }
            }
            if (ways_.isCancelled()) {
                return {};
            }
        }
        return best;
    }

    /// Costs between one armpit and some shoulder points that keep a line from touching elsewhere
    /// the lines that it separates.
    std::vector<double> keptOff(std::vector<double> costs, int armpit,
                                const std::vector<std::size_t>& shoulders) const {
        std::vector<char> isOff(static_cast<std::size_t>(ways_.links().vertexCount()), 0);
        for (const auto* line : {&top_.under, &top_.ridge}) {
            for (const int v : *line) {
                isOff[v] = 1;
            }
        }
        isOff[armpit] = 0;
        for (const std::size_t shoulder : shoulders) {
            isOff[top_.ridge[shoulder]] = 0;
        }
        const Edges& edges = ways_.links().table().edges;
        for (Eigen::Index e = 0; e < edges.rows(); ++e) {
            costs[static_cast<std::size_t>(e)] *=
                isOff[edges(e, 0)] != 0 || isOff[edges(e, 1)] != 0 ? kForbidden : 1;
        }
        return costs;
    }

    void take(Armhole armhole) {
        if (!armhole.way.empty()) {
            top_.armhole = std::move(armhole.way);
            top_.armpit = armhole.armpit;
            top_.shoulder = armhole.shoulder;
        }
    }

    double shiftOf(const std::vector<int>& way, std::size_t a, std::size_t b) const {
        const auto first = way.begin();
        return ways_.length({first + static_cast<std::ptrdiff_t>(std::min(a, b)),
                             first + static_cast<std::ptrdiff_t>(std::max(a, b)) + 1});
    }

    /// Places of a path within reach of one place, about a step apart, including it; both mm.
    std::vector<std::size_t> within(const std::vector<int>& way, std::size_t middle, double reach,
                                    double step) const {
        std::vector<std::size_t> places{middle};
        for (const int direction : {-1, 1}) {
            double last = 0;
            for (std::size_t k = middle; k > 1 && k + 2 < way.size();) {
                k += static_cast<std::size_t>(direction);
                const double shift = shiftOf(way, middle, k);
                if (shift > reach) {
                    break;
                }
                const auto before = k - static_cast<std::size_t>(direction);
                if (pull_.isAtSure(way[k]) != pull_.isAtSure(way[before])) {
                    places.insert(places.end(), {before, k});
                } else if (shift - last >= step) {
                    last = shift;
                    places.push_back(k);
                }
            }
        }
        return places;
    }

    const BodyWays& ways_;
    const SeamPull& pull_;
    const int side_;
    TopSide& top_;
};

/// Finds the armhole of a side whose other lines are known. If cuts or lines of the mesh lead it,
/// its armpit and shoulder point move there. It stays empty if there is no path.
void findArmhole(const BodyWays& ways, const SeamPull& pull, int side, TopSide& top) {
    ArmholeFinder(ways, pull, side, top).run();
}

/// Share of a cuff's height in which the under line, or the ridge, ends.
constexpr double kEndPart = 0.4;
/// Without a sleeve the under line falls steeply: length of its first stretch, and fall, mm.
constexpr double kFirstStretch = 80, kSteepFall = 60;
constexpr int kArmpitRounds = 5;
/// Outward lean of the line from armpit to shoulder point, radians.
constexpr double kLean = 8 * std::numbers::pi / 180;

/// Vertices of a rim above or below a height that divides its extent.
std::vector<int> partOf(const BodyWays& ways, const RimLoop& loop, bool isUpper) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const int v : loop.vertices) {
        least = std::min(least, ways.height(v));
        most = std::max(most, ways.height(v));
    }
    std::vector<int> part;
    for (const int v : loop.vertices) {
        const double share = (ways.height(v) - least) / std::max(most - least, 1e-9);
        if (isUpper ? share >= 1 - kEndPart : share <= kEndPart) {
            part.push_back(v);
        }
    }
    return part;
}

std::vector<int> halfOf(const BodyWays& ways, const RimLoop& loop, int side) {
    std::vector<int> half;
    std::ranges::copy_if(loop.vertices, std::back_inserter(half),
                         [&](int v) { return side * ways.across(v) > 0; });
    return half;
}

class TopSideFinder {
public:
    TopSideFinder(const BodyWays& ways, const SeamPull& pull, int side)
        : ways_(ways), pull_(pull), side_(side) {}

    std::optional<TopSide> run() {
        const GarmentBody& body = ways_.body();
        const auto cuffs = body.pair(OpeningKind::Cuff);
        const BodyOpening* hem = body.find(OpeningKind::Hem);
        const BodyOpening* neck = body.find(OpeningKind::Neck);
        if (!cuffs || !hem || !neck) {
            return std::nullopt;
        }
        const RimLoop& cuff = (*cuffs)[side_ < 0 ? 0 : 1]->loop;
        const std::vector<int> low = partOf(ways_, cuff, false), high = partOf(ways_, cuff, true);
        const std::vector<int> hemHalf = halfOf(ways_, hem->loop, side_);
        const std::vector<int> neckHalf = halfOf(ways_, neck->loop, side_);
        std::vector<double> trunk = ways_.silhouette();
        top_.under = ways_.cheapest(trunk, low, hemHalf);
        top_.ridge = ways_.cheapest(ways_.silhouette(), neckHalf, high);
        if (top_.under.size() < 3 || top_.ridge.size() < 2) {
            return std::nullopt;
        }
        top_.hasSleeve = !fallsAtOnce();
        if (!top_.hasSleeve) {
            trunk = ways_.envelope();
            top_.under = ways_.cheapest(trunk, low, hemHalf);
        }
        top_.under = pull_.pulled(top_.under, trunk, low, hemHalf);
        top_.ridge = pull_.pulled(top_.ridge, ways_.silhouette(), neckHalf, high);
        if (top_.under.size() < 3 || top_.ridge.size() < 2) {
            return std::nullopt;
        }
        top_.shoulder = top_.ridge.size() - 1;
        if (top_.hasSleeve) {
            findArmpit();
            findShoulder();
            findArmhole(ways_, pull_, side_, top_);
        }
        return top_;
    }

private:
    Eigen::Vector2d seen(int vertex) const { return ways_.seen(vertex, side_); }

    bool fallsAtOnce() const {
        double length = 0;
        for (std::size_t k = 1; k < top_.under.size() && length < kFirstStretch; ++k) {
            length += (ways_.at(top_.under[k]) - ways_.at(top_.under[k - 1])).norm();
            if (ways_.height(top_.under[0]) - ways_.height(top_.under[k]) > kSteepFall) {
                return true;
            }
        }
        return false;
    }

    /// The corner of the under line: farthest along the bisector of the angle there.
    void findArmpit() {
        const std::vector<int>& way = top_.under;
        const Eigen::Vector2d cuff = seen(way.front()), hem = seen(way.back());
        const auto farthest = [&](const Eigen::Vector2d& direction) {
            std::size_t found = 0;
            for (std::size_t k = 1; k < way.size(); ++k) {
                if (direction.dot(seen(way[k]) - seen(way[found])) > 0) {
                    found = k;
                }
            }
            return found;
        };
        const Eigen::Vector2d chord = (hem - cuff).normalized();
        const Eigen::Vector2d inward(-std::abs(chord.y()), std::abs(chord.x()));
        std::size_t corner = farthest(inward);
        for (int round = 0; round < kArmpitRounds && corner > 0 && corner + 1 < way.size();
             ++round) {
            const Eigen::Vector2d here = seen(way[corner]);
            corner = farthest((here - cuff).normalized() - (hem - here).normalized());
        }
        top_.armpit = std::clamp<std::size_t>(corner, 1, way.size() - 2);
    }

    void findShoulder() {
        const Eigen::Vector2d armpit = seen(top_.under[top_.armpit]);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 1; k + 1 < top_.ridge.size(); ++k) {
            const Eigen::Vector2d up = seen(top_.ridge[k]) - armpit;
            const double lean = std::atan2(up.x(), up.y());
            if (std::abs(lean - kLean) < nearest) {
                nearest = std::abs(lean - kLean);
                top_.shoulder = k;
            }
        }
    }

    const BodyWays& ways_;
    const SeamPull& pull_;
    const int side_;
    TopSide top_;
};

}  // namespace

std::optional<TopSide> topSide(const BodyWays& ways, const SeamPull& pull, int side) {
    return TopSideFinder(ways, pull, side).run();
}

}  // namespace toile::tailor
