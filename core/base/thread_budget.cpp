// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/thread_budget.h"

#include <algorithm>
#include <future>
#include <system_error>
#include <thread>
#include <utility>

namespace toile {

std::shared_ptr<ThreadBudget>& ThreadBudget::current() {
    // Never destroyed: abandoned threads may ask for it at the program's end.
    static const auto& ofTheMachine =
        *new std::shared_ptr<ThreadBudget>(std::make_shared<ThreadBudget>(
            std::max(1, static_cast<int>(std::thread::hardware_concurrency())) - 1));
    thread_local std::shared_ptr<ThreadBudget> mine = ofTheMachine;
    return mine;
}

ThreadBudget::Worker::Worker(std::shared_ptr<ThreadBudget> budget)
    : before_(std::exchange(current(), std::move(budget))) {
    --current()->spare_;
}

ThreadBudget::Worker::~Worker() {
    ++current()->spare_;
    current() = std::move(before_);
}

bool ThreadBudget::take() {
    int spare = spare_;
    while (spare > 0 && !spare_.compare_exchange_weak(spare, spare - 1)) {
    }
    return spare > 0;
}

void runSideBySide(const std::function<void()>& first, const std::function<void()>& second) {
    const std::shared_ptr<ThreadBudget> budget = ThreadBudget::current();
    if (!budget->take()) {
        first();
        second();
        return;
    }
    struct Taken {
        ThreadBudget& budget;
        ~Taken() { ++budget.spare_; }
    } const taken{*budget};
    std::future<void> beside;  // ends before the thread is given back
    try {
        beside = std::async(std::launch::async, [&budget, &second] {
            ThreadBudget::current() = budget;
            second();
        });
    } catch (const std::system_error&) {  // the system has no more threads
        first();
        second();
        return;
    }
    first();
    beside.get();
}

}  // namespace toile
