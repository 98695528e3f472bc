// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/seam/matched_interval.h"

namespace toile {
namespace {

std::vector<std::pair<double, double>> parts(const seam::ArcSet& set, double from, double to) {
    std::vector<std::pair<double, double>> list;
    for (const seam::Arc& arc : set.outside({from, to})) {
        list.emplace_back(arc.from, arc.to);
    }
    return list;
}

using List = std::vector<std::pair<double, double>>;

TEST(ArcSet, SaysWhatIsOutside) {
    seam::ArcSet set(10);
    EXPECT_EQ(parts(set, 2, 9), (List{{2, 9}}));
    set.add({3, 4});
    set.add({6, 7});
    EXPECT_EQ(parts(set, 2, 9), (List{{2, 3}, {4, 6}, {7, 9}}));
    set.add({4, 6});
    EXPECT_EQ(parts(set, 2, 9), (List{{2, 3}, {7, 9}}));
    EXPECT_EQ(parts(set, 3, 7), (List{}));
}

TEST(ArcSet, GoesRound) {
    seam::ArcSet set(10);
    set.add({8, 12});
    EXPECT_EQ(parts(set, 0, 10), (List{{2, 8}}));
    EXPECT_EQ(parts(set, 7, 15), (List{{7, 8}, {12, 15}}));
    EXPECT_EQ(parts(set, -5, 5), (List{{-5, -2}, {2, 5}}));
    set.add({-8, -2});  // 2 to 8
    EXPECT_EQ(parts(set, 3, 13), (List{}));
}

}  // namespace
}  // namespace toile
