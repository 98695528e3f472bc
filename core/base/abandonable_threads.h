// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <list>

namespace toile {

/// Threads for work that may have to be left behind: a factorisation that nobody wants any more
/// cannot be stopped, only left to itself. What is abandoned runs on, is kept by the process, and
/// is waited for at the program's end: they are joined from `atexit`, asked for before the first
/// thread starts and anew whenever some are abandoned. So static objects that were there by then
/// outlive the threads; those that the work itself makes after it was abandoned (a function's own
/// static at its first call) do not.
/// Rules for the work: it owns what it uses (shared pointers, no references to the caller's), ends
/// soon where it can, and throws nothing.
/// One owner; what several owners abandon meets in one place under a lock.
class AbandonableThreads {
public:
    AbandonableThreads();
    /// Abandons what still runs.
    ~AbandonableThreads();
    AbandonableThreads(const AbandonableThreads&) = delete;
    AbandonableThreads& operator=(const AbandonableThreads&) = delete;

    /// Runs `work` on a thread of its own.
    /// @return false where the system has no more threads: the work is not done then
    bool start(std::function<void()> work);
    /// Waits until all work is done.
    void join();
    /// Returns at once. The threads are the process's from then on.
    void abandon() noexcept;

    /// How many abandoned threads still run: they take cores and memory from what comes after.
    static int stillRunning();
    /// Waits for all abandoned threads: at the program's end, and for tests that measure time.
    static void joinAbandoned();

private:
    struct Thread;
    struct Keeper;

    /// A list, so that its nodes can be handed over.
    std::list<Thread> threads_;
};

}  // namespace toile
