// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/top_seams.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/tailor/armhole.h"

namespace toile::tailor {
namespace {

/// Of a cuff, seen along the height, the part in which the under line and the ridge end.
constexpr double kEndPart = 0.4;
/// Without a sleeve the under line falls by this much of its first stretch, both mm.
constexpr double kFirstStretch = 80, kSteepFall = 60;
constexpr int kArmpitRounds = 5;
/// From the armpit the shoulder point lies so far outward of straight up, radians.
constexpr double kLean = 8 * std::numbers::pi / 180;

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
