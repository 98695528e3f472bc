// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/progress.h"

#include <limits>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Progress, GoesFromNothingToAll) {
    Progress progress;
    progress.start(4);
    EXPECT_EQ(progress.fraction(), 0);
    progress.advance(1);
    EXPECT_EQ(progress.fraction(), 0.25);
    progress.advance(3);
    EXPECT_EQ(progress.fraction(), 1);
}

TEST(Progress, PartsOfALongerTaskFollowEachOther) {
    Progress progress;
    progress.setShare(0, 0.75);
    EXPECT_EQ(progress.fraction(), 0);
    progress.start(3);
    progress.advance(2);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.5);
    progress.advance(1);
    progress.setShare(0.75, 1);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.75);
    progress.start(10);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.75);
    progress.advance(10);
    EXPECT_DOUBLE_EQ(progress.fraction(), 1);
}

TEST(Progress, AReportNeverGoesBack) {
    Progress progress;
    const Progress& worker = progress;
    worker.report(0.5);
    worker.report(0.25);
    worker.report(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(progress.fraction(), 0.5);
    worker.report(7);
    EXPECT_EQ(progress.fraction(), 1);
    progress.setShare(0.5, 0.75);
    worker.report(0.5);
    EXPECT_EQ(progress.fraction(), 0.625);
}

TEST(Progress, PartsAddToTheWholeAndAreCancelledWithIt) {
    Progress progress;
    progress.setShare(0.5, 1);
    {
        const Progress first(progress, 0.25);
        const Progress second(progress, 0.75);
        const Progress third(second, 0.5);
        first.report(0.5);
        EXPECT_EQ(progress.fraction(), 0.5 + 0.5 * 0.125);
        third.report(1);
        EXPECT_EQ(second.fraction(), 0.5);
        EXPECT_EQ(progress.fraction(), 0.5 + 0.5 * (0.125 + 0.375));
        second.report(0.25);
        second.report(1);
        first.report(1);
        EXPECT_EQ(progress.fraction(), 1);
        progress.cancel();
        EXPECT_TRUE(third.isCancelled());
    }
    Progress whole;
    Progress part(whole, 1);
    part.cancel();
    EXPECT_TRUE(part.isCancelled());
    EXPECT_FALSE(whole.isCancelled());
}

TEST(Progress, AStageTakesPartOfWhatIsLeft) {
    Progress progress;
    progress.setShare(0.5, 1);
    const Progress part(progress, 0.5);
    part.report(0.5);
    part.step();
    EXPECT_DOUBLE_EQ(part.fraction(), 0.55);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.5 + 0.5 * 0.5 * 0.55);
    progress.step();
    EXPECT_GT(progress.fraction(), 0.5 + 0.5 * 0.5 * 0.55);
    for (int stage = 0; stage < 1000; ++stage) {
        part.step();
        EXPECT_LE(part.fraction(), 1);
    }
}

TEST(Progress, CountsWhatManyThreadsReportAtOnce) {
    Progress progress;
    constexpr int kThreads = 4;
    constexpr int kSteps = 1 << 12;  // powers of two: the sums are exact in any order
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t) {
        threads.emplace_back([&progress] {
            const Progress part(progress, 1.0 / kThreads);
            for (int i = 1; i <= kSteps; ++i) {
                part.report(static_cast<double>(i) / kSteps);
            }
        });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(progress.fraction(), 1);
}

}  // namespace
}  // namespace toile
