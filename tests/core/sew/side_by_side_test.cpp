// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sew/side_by_side.h"

#include <new>
#include <vector>

#include <gtest/gtest.h>

namespace toile::sew {
namespace {

TEST(SideBySide, DoesEachOnce) {
    for (const int threads : {1, 3, 64}) {
        for (const std::size_t count : {0U, 1U, 999U, 5001U}) {
            std::vector<int> done(count);
            sideBySide(threads, count, [&](std::size_t i) { ++done[i]; });
            EXPECT_EQ(done, std::vector<int>(count, 1));
        }
    }
}

TEST(SideBySide, WhatIsThrownComesToTheCaller) {
    for (const int threads : {1, 3}) {
        for (const std::size_t bad : {0U, 4999U}) {
            const auto work = [bad](std::size_t i) {
                if (i == bad) {
                    throw std::bad_alloc();
                }
            };
            EXPECT_THROW(sideBySide(threads, 5000, work), std::bad_alloc);
        }
    }
}

}  // namespace
}  // namespace toile::sew
