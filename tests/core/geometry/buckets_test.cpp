// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/buckets.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Buckets, HoldItemsByKeyInTheOrderInWhichTheyCame) {
    const std::string text = "to be or not to be";
    geometry::Buckets<int> places('z' + 1, [&text](auto add) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            add(text[i], static_cast<int>(i));
        }
    });
    EXPECT_EQ(places.keyCount(), 'z' + 1);
    EXPECT_TRUE(std::ranges::equal(places['o'], std::vector{1, 6, 10, 14}));
    EXPECT_TRUE(places['z'].empty());
    EXPECT_EQ(places.items().size(), text.size());
    std::ranges::reverse(places['b']);
    EXPECT_TRUE(std::ranges::equal(places['b'], std::vector{16, 3}));
}

TEST(Buckets, MayBeWithoutKeysOrItems) {
    EXPECT_EQ(geometry::Buckets<>().keyCount(), 0);
    const geometry::Buckets<std::string> none(2, [](auto) {});
    EXPECT_TRUE(none[0].empty());
    EXPECT_TRUE(none[1].empty());
}

}  // namespace
}  // namespace toile
