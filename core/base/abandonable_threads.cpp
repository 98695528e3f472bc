// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/abandonable_threads.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace toile {

struct AbandonableThreads::Thread {
    std::thread thread;
    /// Set by the thread as its last deed; shared, as the thread may be gone before its owner
    /// looks.
    std::shared_ptr<std::atomic<bool>> isDone = std::make_shared<std::atomic<bool>>(false);
};

/// The process's abandoned threads. Made once and never destroyed: a static object would end with
/// the statics of this file, and some thread may still come here then.
struct AbandonableThreads::Keeper {
    std::mutex mutex;
    std::list<Thread> threads;

    Keeper() { std::atexit(&AbandonableThreads::joinAbandoned); }

    static Keeper& instance() {
        static auto* keeper = new Keeper;
        return *keeper;
    }

    /// Takes out the threads that are done. The caller holds the lock and joins them after it.
    std::list<Thread> takeDone() {
        std::list<Thread> done;
        for (auto kept = threads.begin(); kept != threads.end();) {
            const auto next = std::next(kept);
            if (*kept->isDone) {
                done.splice(done.end(), threads, kept);
            }
            kept = next;
        }
        return done;
    }
};

AbandonableThreads::AbandonableThreads() = default;

AbandonableThreads::~AbandonableThreads() {
    abandon();
}

bool AbandonableThreads::start(std::function<void()> work) {
    Keeper::instance();  // made here, where it may throw: `abandon` may not
    std::list<Thread> made(1);
    try {
        made.front().thread =
            std::thread([work = std::move(work), isDone = made.front().isDone]() mutable {
                work();
                work = nullptr;  // gives back what it owns
                *isDone = true;
            });
    } catch (const std::system_error&) {
        return false;
    }
    threads_.splice(threads_.end(), made);
    return true;
}

void AbandonableThreads::join() {
    for (Thread& kept : threads_) {
        kept.thread.join();
    }
    threads_.clear();
}

void AbandonableThreads::abandon() noexcept {
    if (threads_.empty()) {
        return;
    }
    Keeper& keeper = Keeper::instance();
    std::list<Thread> done;
    {
        const std::lock_guard lock(keeper.mutex);
        keeper.threads.splice(keeper.threads.end(), threads_);
        done = keeper.takeDone();
    }
    // What was asked for last runs first: before the end of statics made since the thread began.
    // Where there is no room for it, the earlier one stands.
    std::atexit(&AbandonableThreads::joinAbandoned);
    for (Thread& kept : done) {
        kept.thread.join();
    }
}

int AbandonableThreads::stillRunning() {
    Keeper& keeper = Keeper::instance();
    const std::lock_guard lock(keeper.mutex);
    return static_cast<int>(
        std::ranges::count_if(keeper.threads, [](const Thread& kept) { return !*kept.isDone; }));
}

void AbandonableThreads::joinAbandoned() {
    Keeper& keeper = Keeper::instance();
    std::list<Thread> threads;
    {
        const std::lock_guard lock(keeper.mutex);
        std::swap(threads, keeper.threads);
    }
    for (Thread& kept : threads) {
        kept.thread.join();
    }
}

}  // namespace toile
