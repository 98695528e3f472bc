// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <new>

#include <gtest/gtest.h>

#include "core/linalg/front_tree.h"

namespace toile::linalg {
namespace {

/// Tasks of which each waits for the one before it, or none for any.
FrontTree someTasks(int count, bool inARow) {
    FrontTree tree;
    for (int t = 0; t < count; ++t) {
        tree.tasks.push_back({t, t, inARow && t + 1 < count ? t + 1 : -1, 1.0});
    }
    tree.taskChildren = geometry::Buckets<>(count, [&](const auto& add) {
        for (int t = 0; t + 1 < count && inARow; ++t) {
            add(t + 1, t);
        }
    });
    return tree;
}

TEST(FrontSchedule, DoesEachTaskOnce) {
    for (const bool inARow : {false, true}) {
        const FrontTree tree = someTasks(50, inARow);
        for (const FrontSense sense : {FrontSense::Upwards, FrontSense::Downwards}) {
            std::atomic<int> done = 0;
            EXPECT_EQ(doFronts(tree, sense, 4, [&](int) { return ++done > 0; }), FrontsDone::All);
            EXPECT_EQ(done, 50);
        }
    }
}

TEST(FrontSchedule, WhatATaskThrowsComesToTheCaller) {
    for (const bool inARow : {false, true}) {
        const FrontTree tree = someTasks(50, inARow);
        for (const int threads : {1, 4}) {
            const auto work = [](int t) { return t == 30 ? throw std::bad_alloc() : true; };
            EXPECT_THROW(doFronts(tree, FrontSense::Upwards, threads, work), std::bad_alloc);
        }
    }
}

}  // namespace
}  // namespace toile::linalg
