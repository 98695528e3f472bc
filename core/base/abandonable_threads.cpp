// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/abandonable_threads.h"

#include <atomic>
#include <cstdlib>
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

namespace {

/// The process's abandoned threads. Made once and never destroyed: a static object would end with
/// the statics of this file, and some thread may still come here then.
template <class Thread>
struct Keeper {
    std::mutex mutex;
    std::vector<std::unique_ptr<Thread>> threads;
    bool isRegistered = false;

    static Keeper& instance() {
        static auto* keeper = new Keeper;
        return *keeper;
    }

    /// Takes out the threads that are done. The caller holds the lock and joins them after it.
    std::vector<std::unique_ptr<Thread>> takeDone() {
        std::vector<std::unique_ptr<Thread>> done;
        std::erase_if(threads, [&done](std::unique_ptr<Thread>& kept) {
            if (!*kept->isDone) {
                return false;
            }
            done.push_back(std::move(kept));
            return true;
        });
        return done;
    }
};

}  // namespace

AbandonableThreads::AbandonableThreads() = default;

AbandonableThreads::~AbandonableThreads() {
    abandon();
}

bool AbandonableThreads::start(std::function<void()> work) {
    auto kept = std::make_unique<Thread>();
    threads_.reserve(threads_.size() + 1);  // nothing may throw once the thread runs
    try {
        kept->thread = std::thread([work = std::move(work), isDone = kept->isDone]() mutable {
            work();
            work = nullptr;  // gives back what it owns
            *isDone = true;
        });
    } catch (const std::system_error&) {
        return false;
    }
    threads_.push_back(std::move(kept));
    return true;
}

void AbandonableThreads::join() {
    for (const auto& kept : threads_) {
        kept->thread.join();
    }
    threads_.clear();
}

void AbandonableThreads::abandon() {
    if (threads_.empty()) {
        return;
    }
    auto& keeper = Keeper<Thread>::instance();
    std::vector<std::unique_ptr<Thread>> done;
    {
        const std::lock_guard lock(keeper.mutex);
        for (auto& kept : threads_) {
            keeper.threads.push_back(std::move(kept));
        }
        threads_.clear();
        done = keeper.takeDone();
        if (!keeper.isRegistered) {
            keeper.isRegistered = std::atexit(&AbandonableThreads::joinAbandoned) == 0;
        }
    }
    for (const auto& kept : done) {
        kept->thread.join();
    }
}

int AbandonableThreads::stillRunning() {
    auto& keeper = Keeper<Thread>::instance();
    const std::lock_guard lock(keeper.mutex);
    int running = 0;
    for (const auto& kept : keeper.threads) {
        running += *kept->isDone ? 0 : 1;
    }
    return running;
}

void AbandonableThreads::joinAbandoned() {
    auto& keeper = Keeper<Thread>::instance();
    std::vector<std::unique_ptr<Thread>> threads;
    {
        const std::lock_guard lock(keeper.mutex);
        std::swap(threads, keeper.threads);
    }
    for (const auto& kept : threads) {
        kept->thread.join();
    }
}

}  // namespace toile
