// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/abandonable_threads.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/stopwatch.h"

namespace toile {
namespace {

using std::chrono::milliseconds;

TEST(AbandonableThreads, JoinWaitsForAllWork) {
    std::atomic<int> done{0};
    AbandonableThreads threads;
    for (int t = 0; t < 4; ++t) {
        ASSERT_TRUE(threads.start([&done] {
            std::this_thread::sleep_for(milliseconds(20));
            ++done;
        }));
    }
    threads.join();
    EXPECT_EQ(done, 4);
    EXPECT_EQ(AbandonableThreads::stillRunning(), 0);
}

TEST(AbandonableThreads, LeavesWorkBehindAndKeepsWhatItUses) {
    const auto data = std::make_shared<std::vector<int>>(1000, 1);
    const auto isDone = std::make_shared<std::atomic<bool>>(false);
    const Stopwatch time;
    {
        AbandonableThreads threads;
        ASSERT_TRUE(threads.start([data, isDone] {
            std::this_thread::sleep_for(milliseconds(300));
            data->back() = 2;
            *isDone = true;
        }));
    }
    EXPECT_LT(time.seconds(), 0.2);
    EXPECT_FALSE(*isDone);
    EXPECT_EQ(AbandonableThreads::stillRunning(), 1);
    AbandonableThreads::joinAbandoned();
    EXPECT_TRUE(*isDone);
    EXPECT_EQ(data->back(), 2);
    EXPECT_EQ(data.use_count(), 1);
    EXPECT_EQ(AbandonableThreads::stillRunning(), 0);
}

TEST(AbandonableThreads, AbandonsSeveralWithoutThrowing) {
    static_assert(noexcept(std::declval<AbandonableThreads&>().abandon()));
    const auto mayEnd = std::make_shared<std::atomic<bool>>(false);
    AbandonableThreads threads;
    for (int t = 0; t < 3; ++t) {
        ASSERT_TRUE(threads.start([mayEnd] { mayEnd->wait(false); }));
    }
    threads.abandon();
    EXPECT_EQ(AbandonableThreads::stillRunning(), 3);
    threads.join();  // none of its own any more
    *mayEnd = true;
    mayEnd->notify_all();
    AbandonableThreads::joinAbandoned();
    EXPECT_EQ(AbandonableThreads::stillRunning(), 0);
}

TEST(AbandonableThreads, ClearsAwayEarlierOnesThatHaveEnded) {
    for (int round = 0; round < 50; ++round) {
        AbandonableThreads threads;
        ASSERT_TRUE(threads.start([] {}));
    }
    AbandonableThreads::joinAbandoned();
    EXPECT_EQ(AbandonableThreads::stillRunning(), 0);
}

/// Made before anything is abandoned, destroyed after everything is: a thread that still used it at
/// the program's end would be seen by the sanitizers, and by the value.
struct UsedToTheEnd {
    std::unique_ptr<std::atomic<int>> value = std::make_unique<std::atomic<int>>(0);
    ~UsedToTheEnd() { value.reset(); }
} usedToTheEnd;

TEST(AbandonableThreads, AreWaitedForAtTheProgramsEnd) {
    AbandonableThreads threads;
    ASSERT_TRUE(threads.start([] {
        for (int i = 0; i < 50; ++i) {
            std::this_thread::sleep_for(milliseconds(10));
            ++*usedToTheEnd.value;
        }
    }));
    threads.abandon();
    EXPECT_EQ(AbandonableThreads::stillRunning(), 1);
}

}  // namespace
}  // namespace toile
