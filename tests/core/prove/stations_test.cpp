// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prove/stations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/core/prove/proved_garment.h"
#include "tests/core/support/shared_data.h"

namespace toile::prove {
namespace {

class SampleStations : public testing::TestWithParam<const char*> {
protected:
    SampleStations()
        : garment_(test::sourceFile(std::string("resources/samples/") + GetParam() + ".obj")),
          pattern_(*restPattern(garment_.source(), {})) {}

    const RestLoop& loopOf(const Station& station) const {
        return *pattern_.pieces[station.piece]->loops[station.loop];
    }
    Eigen::RowVector3d spaceAt(const Stations& stations, const Station& station) const {
        return loopOf(station).spaceAt(
            stations.places[station.piece][station.loop][station.number]);
    }

    test::ProvedGarment garment_;
    RestPattern pattern_;
};

TEST_P(SampleStations, LieAcrossFromEachOtherAlongSeams) {
    for (const double edge : {8.0, 25.0}) {
        for (const bool atVertices : {false, true}) {
            const Stations stations =
                placeStations(garment_.garment().seams, pattern_, edge, atVertices);
            EXPECT_FALSE(stations.sewn.empty());
            for (const auto& [a, b] : stations.sewn) {
                // A corner is taken for that of the other side within a fifth of an edge.
                EXPECT_LT((spaceAt(stations, a) - spaceAt(stations, b)).norm(), 0.5 * edge);
            }
        }
    }
}

TEST_P(SampleStations, LeaveNoEdgeMuchLongerThanAsked) {
    constexpr double kEdge = 12;
    for (const bool atVertices : {false, true}) {
        const Stations stations =
            placeStations(garment_.garment().seams, pattern_, kEdge, atVertices);
        for (std::size_t p = 0; p < stations.places.size(); ++p) {
            for (std::size_t l = 0; l < stations.places[p].size(); ++l) {
                const auto& places = stations.places[p][l];
                const RestLoop& loop = *pattern_.pieces[p]->loops[l];
                ASSERT_GE(places.size(), 3u);
                EXPECT_TRUE(std::ranges::is_sorted(places));
                for (std::size_t k = 0; k < places.size(); ++k) {
                    const double next =
                        k + 1 < places.size() ? places[k + 1] : places[0] + loop.length();
                    EXPECT_LT(loop.restLength(places[k], next), 1.7 * kEdge);
                    EXPECT_GT(loop.restLength(places[k], next), 0.1 * kEdge);
                }
            }
        }
    }
}

TEST_P(SampleStations, KeepEveryCorner) {
    constexpr double kEdge = 12;
    const Stations stations = placeStations(garment_.garment().seams, pattern_, kEdge, false);
    for (std::size_t p = 0; p < stations.places.size(); ++p) {
        const RestLoop& loop = *pattern_.pieces[p]->loops[0];
        for (const double corner : loop.corners()) {
            EXPECT_TRUE(std::ranges::any_of(stations.places[p][0], [&](double place) {
                const double way = std::abs(place - corner);
                return std::min(way, loop.length() - way) < 0.2 * kEdge;
            }));
        }
    }
}

/// No point is left open between two that are sewn.
TEST_P(SampleStations, StrictlyWithinASewnSideAreAllSewn) {
    const auto& seams = garment_.garment().seams;
    for (const double edge : {4.0, 12.0, 25.0}) {
        for (const bool atVertices : {false, true}) {
            const Stations stations = placeStations(seams, pattern_, edge, atVertices);
            std::set<std::array<int, 3>> sewn;
            for (const auto& [a, b] : stations.sewn) {
                sewn.insert({a.piece, a.loop, a.number});
                sewn.insert({b.piece, b.loop, b.number});
            }
            for (const Seam& seam : seams.seams) {
                if (!isSewn(seam, pattern_)) {
                    continue;
                }
                for (const SeamSide* side : {&seam.left, &seam.right}) {
                    const auto [low, high] = std::minmax(side->start, side->end);
                    const double turn = toile::prove::loopOf(*side, pattern_).length();
                    const auto& places = stations.places[side->piece][side->loop];
                    for (int k = 0; k < static_cast<int>(places.size()); ++k) {
                        const double at = places[k] + std::ceil((low - places[k]) / turn) * turn;
                        if (at > low + 1e-6 && at < high - 1e-6) {
                            EXPECT_TRUE(sewn.contains({side->piece, side->loop, k}))
                                << seam.name << " at " << at << ", edge " << edge;
                        }
                    }
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Stations, SampleStations,
                         testing::Values("tshirt", "trousers", "cap", "bodice", "skirt"));

}  // namespace
}  // namespace toile::prove
