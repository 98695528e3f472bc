// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>

namespace toile {

/// How many threads one job may still start. A garment's pieces are flattened side by side; where
/// fewer are left than threads, or one is large, a single factorisation takes the idle ones.
/// Thread-safe.
class ThreadBudget {
public:
    /// @param threads  of the whole job; those of its workers count once they are `Worker`s
    explicit ThreadBudget(int threads) : spare_(threads) {}

    /// While it lives the thread that made it works for a budget and takes one thread of it.
    /// Before and afterwards, for whatever that was; of all threads that never did, the budget is
    /// the machine's cores, but one for the caller.
    class Worker {
    public:
        explicit Worker(std::shared_ptr<ThreadBudget> budget);
        ~Worker();
        Worker(const Worker&) = delete;
        Worker& operator=(const Worker&) = delete;

    private:
        std::shared_ptr<ThreadBudget> before_;
    };

private:
    friend void runSideBySide(const std::function<void()>&, const std::function<void()>&);

    static std::shared_ptr<ThreadBudget>& current();
    bool take();

    std::atomic<int> spare_;
};

/// Runs both: at a time where the caller's budget has a thread to spare, else the first before the
/// second. So neither may wait for the other, and what they do must not depend on it. `first` runs
/// on the calling thread. Throws what one of them throws, after both have ended.
void runSideBySide(const std::function<void()>& first, const std::function<void()>& second);

}  // namespace toile
