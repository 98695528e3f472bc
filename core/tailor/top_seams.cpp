// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/top_seams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/segment.h"

namespace toile::tailor {
namespace {

/// Of a cuff, seen along the height, the part in which the under line and the ridge end.
constexpr double kEndPart = 0.4;
/// Without a sleeve the under line falls by this much of its first stretch, both mm.
constexpr double kFirstStretch = 80, kSteepFall = 60;
constexpr int kArmpitRounds = 5;
/// From the armpit the shoulder point lies so far outward of straight up, radians.
constexpr double kLean = 8 * std::numbers::pi / 180;
/// By how much of its height an armhole is hollow towards the body.
constexpr double kHollow = 0.16;
/// A line this far off its target, mm, costs double; at most as much as at so many times that.
constexpr double kOff = 20, kMostOff = 5, kLengthCost = 0.2;
/// How much less that counts where lines of the mesh may lead.
constexpr double kKeenWithLines = 0.1;
/// Which half of the garment a line may run through, by `facing`, and how near the middle.
constexpr double kHalfFacing = -0.35, kNearMiddle = 20;
constexpr double kForbidden = 1e4;
/// How far armpit and shoulder point may go, mm, to meet a line of the mesh, and what that costs.
constexpr double kArmpitReach = 50, kShoulderReach = 110, kShift = 0.15;
constexpr int kArmpitTries = 5;
/// From here on a line of the mesh is taken for the armhole seam.
constexpr double kArmholeSure = 0.45;

/// Vertices of a rim on one side of a height that divides its extent.
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
        top_.shoulder = top_.ridge.size() - 1;
        if (top_.hasSleeve) {
            findArmpit();
            findShoulder();
            findArmhole();
        }
        return top_;
    }

private:
    /// Seen from ahead, outward positive.
    Eigen::Vector2d seen(int vertex) const {
        return {side_ * ways_.across(vertex), ways_.height(vertex)};
    }

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

    /// The corner of the under line: farthest in the direction that halves the angle there.
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

    /// What an armhole from the armpit to a point of the ridge costs, through one half.
    std::vector<double> armholeCosts(int armpit, int shoulder, bool isFront, double keen) const {
        const Eigen::Vector2d from = seen(armpit), way = seen(shoulder) - from;
        const Eigen::Vector2d inward = Eigen::Vector2d(-way.y(), way.x());
        std::vector<Eigen::Vector2d> target;
        constexpr int kParts = 24;
        for (int k = 0; k <= kParts; ++k) {
            const double t = static_cast<double>(k) / kParts;
            target.push_back(from + t * way + kHollow * 4 * t * (1 - t) * inward);
        }
        std::vector<char> isTaken(static_cast<std::size_t>(ways_.links().vertexCount()), 0);
        for (const auto* line : {&top_.under, &top_.ridge}) {
            for (const int v : *line) {
                isTaken[v] = v != armpit && v != shoulder;
            }
        }
        return ways_.costs([&](int v) {
            const double facing = isFront ? ways_.facing(v) : -ways_.facing(v);
            if (isTaken[v] != 0 || facing < kHalfFacing || side_ * ways_.across(v) < kNearMiddle) {
                return kForbidden;
            }
            double off = std::numeric_limits<double>::infinity();
            for (std::size_t k = 1; k < target.size(); ++k) {
                off = std::min(off, geometry::distanceToSegment(seen(v), target[k - 1], target[k]));
            }
            const double far = std::min(off / kOff, kMostOff);
            return kLengthCost + keen * far * far;
        });
    }

    struct Armhole {
        std::vector<int> way;
        double cost = std::numeric_limits<double>::infinity();
    };

    double costOf(const std::vector<int>& way, const std::vector<double>& costs) const {
        double sum = 0;
        for (std::size_t k = 1; k < way.size(); ++k) {
            sum += costs[findEdge(ways_.links().table().edges, way[k - 1], way[k])];
        }
        return sum;
    }

    Armhole armhole(std::size_t armpit, std::size_t shoulder, bool isEased) const {
        const int low = top_.under[armpit], high = top_.ridge[shoulder];
        Armhole found{{}, 0};
        for (const bool isFront : {true, false}) {
            std::vector<double> costs =
                armholeCosts(low, high, isFront, isEased ? kKeenWithLines : 1);
            if (isEased) {
                costs = pull_.eased(std::move(costs));
            }
            std::vector<int> half = isFront ? ways_.cheapest(costs, {low}, {high})
                                            : ways_.cheapest(costs, {high}, {low});
            if (half.empty()) {
                return {};
            }
            found.cost += costOf(half, costs);
            found.way.insert(found.way.end(), half.begin() + (isFront ? 0 : 1), half.end());
        }
        return found;
    }

    void findArmhole() {
        top_.armhole = armhole(top_.armpit, top_.shoulder, false).way;
        const std::size_t armpit = top_.armpit, shoulder = top_.shoulder;
        Armhole best;
        std::size_t bestArmpit = armpit, bestShoulder = shoulder;
        for (const std::size_t low : within(top_.under, armpit, kArmpitReach, kArmpitTries)) {
            for (const std::size_t high : within(top_.ridge, shoulder, kShoulderReach, 11)) {
                Armhole one = armhole(low, high, true);
                one.cost += kShift * (shiftOf(top_.under, armpit, low) +
                                      shiftOf(top_.ridge, shoulder, high));
                if (one.cost < best.cost) {
                    best = std::move(one);
                    bestArmpit = low;
                    bestShoulder = high;
                }
            }
        }
        if (pull_.along(best.way) > kArmholeSure) {
            top_.armhole = std::move(best.way);
            top_.armpit = bestArmpit;
            top_.shoulder = bestShoulder;
        }
    }

    double shiftOf(const std::vector<int>& way, std::size_t a, std::size_t b) const {
        const auto first = way.begin();
        return ways_.length({first + static_cast<std::ptrdiff_t>(std::min(a, b)),
                             first + static_cast<std::ptrdiff_t>(std::max(a, b)) + 1});
    }

    /// Places of a way within a reach of one, some of them, that one among them.
    std::vector<std::size_t> within(const std::vector<int>& way, std::size_t middle, double reach,
                                    int tries) const {
        std::vector<std::size_t> places{middle};
        const double step = 2 * reach / (tries - 1);
        for (const int direction : {-1, 1}) {
            double last = 0;
            for (std::size_t k = middle; k > 1 && k + 2 < way.size();) {
                k += static_cast<std::size_t>(direction);
                const double shift = shiftOf(way, middle, k);
                if (shift > reach) {
                    break;
                }
                if (shift - last >= step) {
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
    TopSide top_;
};

}  // namespace

std::optional<TopSide> topSide(const BodyWays& ways, const SeamPull& pull, int side) {
    return TopSideFinder(ways, pull, side).run();
}

}  // namespace toile::tailor
