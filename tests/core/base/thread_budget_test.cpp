// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_budget.h"

#include <atomic>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace toile {
namespace {

/// The threads that two jobs run on.
std::pair<std::thread::id, std::thread::id> threadsOfTwo() {
    std::pair<std::thread::id, std::thread::id> ids;
    runSideBySide([&] { ids.first = std::this_thread::get_id(); },
                  [&] { ids.second = std::this_thread::get_id(); });
    return ids;
}

TEST(ThreadBudget, GivesAThreadWhereOneIsLeft) {
    const auto budget = std::make_shared<ThreadBudget>(2);
    const ThreadBudget::Worker worker(budget);
    for (int again = 0; again < 3; ++again) {
        const auto [first, second] = threadsOfTwo();
        EXPECT_EQ(first, std::this_thread::get_id());
        EXPECT_NE(second, first);
    }
}

TEST(ThreadBudget, RunsInTurnWhereNoneIsLeft) {
    const ThreadBudget::Worker worker(std::make_shared<ThreadBudget>(1));
    std::vector<int> order;
    runSideBySide([&] { order.push_back(1); }, [&] { order.push_back(2); });
    EXPECT_EQ(order, (std::vector<int>{1, 2}));
    EXPECT_EQ(threadsOfTwo().second, std::this_thread::get_id());
}

TEST(ThreadBudget, CountsItsWorkers) {
    const auto budget = std::make_shared<ThreadBudget>(2);
    const ThreadBudget::Worker worker(budget);
    std::thread other([&budget] {
        const ThreadBudget::Worker second(budget);
        EXPECT_EQ(threadsOfTwo().second, std::this_thread::get_id());
    });
    other.join();
    EXPECT_NE(threadsOfTwo().second, std::this_thread::get_id());
}

TEST(ThreadBudget, HoldsForWhatIsStartedWithin) {
    const ThreadBudget::Worker worker(std::make_shared<ThreadBudget>(2));
    const auto inTurn = [] { EXPECT_EQ(threadsOfTwo().second, std::this_thread::get_id()); };
    std::atomic<int> running{0};
    const auto wait = [&running] {
        ++running;
        while (running < 2) {
            std::this_thread::yield();
        }
    };
    runSideBySide(
        [&] {
            wait();
            inTurn();
            ++running;
        },
        [&] {
            wait();
            inTurn();
            while (running < 3) {
                std::this_thread::yield();
            }
        });
}

TEST(ThreadBudget, PassesOnWhatIsThrownAndTakesTheThreadBack) {
    const ThreadBudget::Worker worker(std::make_shared<ThreadBudget>(2));
    const auto fail = [] { throw std::runtime_error("no"); };
    bool hasRun = false;
    const auto run = [&hasRun] { hasRun = true; };
    EXPECT_THROW(runSideBySide(fail, run), std::runtime_error);
    EXPECT_TRUE(hasRun);
    EXPECT_THROW(runSideBySide(run, fail), std::runtime_error);
    EXPECT_NE(threadsOfTwo().second, std::this_thread::get_id());
}

}  // namespace
}  // namespace toile
