// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/front_schedule.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "core/linalg/blas_call.h"

namespace toile::linalg {
namespace {

class FrontSchedule {
public:
    FrontSchedule(const FrontTree& tree, FrontSense sense, const std::function<bool(int)>& work)
        : tree_(tree), sense_(sense), work_(work), left_(tree.tasks.size()) {
        waitsFor_.reserve(left_);
        ready_.reserve(left_);  // allocate now: nothing may be thrown later
        for (int t = 0; t < static_cast<int>(tree.tasks.size()); ++t) {
            waitsFor_.push_back(sense == FrontSense::Upwards
                                    ? static_cast<int>(tree.taskChildren[t].size())
                                    : static_cast<int>(tree.tasks[t].parent >= 0));
            if (waitsFor_.back() == 0) {
                ready_.push_back(t);
            }
        }
    }

    /// Works until no task is left.
    void join() {
        std::unique_lock lock(mutex_);
        while (true) {
            changed_.wait(lock, [this] { return !ready_.empty() || left_ == 0 || isRefused_; });
            if (left_ == 0 || isRefused_) {
                return;
            }
            const int task = takeReady();
            lock.unlock();
            std::exception_ptr fault;
            const bool isDone = isDoneWithoutFault(task, fault);
            lock.lock();
            fault_ = fault_ ? fault_ : fault;
            --left_;
            isRefused_ = isRefused_ || !isDone;
            letGo(task);
            changed_.notify_all();
        }
    }

    /// After all threads have left. @throws the exception of a task
    bool isRefused() const {
        if (fault_) {
            std::rethrow_exception(fault_);
        }
        return isRefused_;
    }

private:
    bool isDoneWithoutFault(int task, std::exception_ptr& fault) const {
        try {
            return work_(task);
        } catch (...) {
            fault = std::current_exception();
            return false;
        }
    }

    /// The ready task with the longest path to the root.
    int takeReady() {
        const auto next = std::ranges::max_element(
            ready_, {}, [this](int t) { return std::pair(tree_.tasks[t].way, t); });
        const int task = *next;
        ready_.erase(next);
        return task;
    }

    void letGo(int task) {
        const auto letGoOne = [this](int t) {
            if (--waitsFor_[t] == 0) {
                ready_.push_back(t);
            }
        };
        if (sense_ == FrontSense::Downwards) {
            std::ranges::for_each(tree_.taskChildren[task], letGoOne);
        } else if (tree_.tasks[task].parent >= 0) {
            letGoOne(tree_.tasks[task].parent);
        }
    }

    const FrontTree& tree_;
    const FrontSense sense_;
    const std::function<bool(int)>& work_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<int> waitsFor_;  ///< per task, the number of other tasks
    std::vector<int> ready_;
    std::size_t left_;
    bool isRefused_ = false;
    std::exception_ptr fault_;  ///< of the first task that threw
};

}  // namespace

FrontsDone doFronts(const FrontTree& tree, FrontSense sense, int threads,
                    const std::function<bool(int)>& work) {
    const auto most = std::min(static_cast<std::size_t>(threads), tree.tasks.size());
    const BlasCall blas(std::max(static_cast<int>(most), 1));
    if (blas.room() == 0) {
        return FrontsDone::NoRoom;
    }
    FrontSchedule schedule(tree, sense, work);
    std::vector<std::thread> others;
    others.reserve(most);
    try {
        while (static_cast<int>(others.size()) + 1 < blas.room()) {
            others.emplace_back([&schedule] { schedule.join(); });
        }
    } catch (const std::exception&) {  // no more threads, or no memory for one
    }
    schedule.join();
    for (std::thread& other : others) {
        other.join();
    }
    return schedule.isRefused() ? FrontsDone::Refused : FrontsDone::All;
}

}  // namespace toile::linalg
