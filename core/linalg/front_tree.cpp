// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linalg/front_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "core/linalg/blas_call.h"
#include "core/linalg/cholmod_workspace.h"

namespace toile::linalg {
namespace {

/// A subtree with less than this part of all work is one task, so that a few threads stay busy.
constexpr double kWholeTask = 1.0 / 24;

/// CHOLMOD's supernodes are the fronts.
Result<void> layFronts(const SymmetricMatrix& pattern, const std::vector<int>& order,
                       FrontTree& tree) {
    CholmodWorkspace workspace;
    cholmod_common& common = workspace.common;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.method[0].ordering = order.empty() ? CHOLMOD_AMD : CHOLMOD_GIVEN;
    cholmod_sparse view = cholmodView(pattern);
    cholmod_factor* factor = cholmod_analyze_p(
        &view, order.empty() ? nullptr : const_cast<int*>(order.data()), nullptr, 0, &common);
    if (factor == nullptr) {
        return Error{ErrorCode::OutOfMemory, {}, "ordering"};
    }
    const int* const perm = static_cast<const int*>(factor->Perm);
    const int* const super = static_cast<const int*>(factor->super);
    const int* const start = static_cast<const int*>(factor->pi);
    const int* const row = static_cast<const int*>(factor->s);
    tree.order.assign(perm, perm + factor->n);
    tree.row.assign(row, row + factor->ssize);
    tree.fronts.resize(factor->nsuper);
    for (std::size_t s = 0; s < factor->nsuper; ++s) {
        Front& front = tree.fronts[s];
        front.first = super[s];
        front.columns = super[s + 1] - super[s];
        front.rows = start[s + 1] - start[s];
        front.rowStart = static_cast<std::size_t>(start[s]);
        front.start = tree.factorSize;
        tree.factorSize += static_cast<std::size_t>(front.rows) * front.columns;
    }
    cholmod_free_factor(&factor, &common);
    return {};
}

/// The front that eliminates each position of the order.
std::vector<int> frontOfPlace(const FrontTree& tree) {
    std::vector<int> frontOf(tree.order.size());
    for (int s = 0; s < static_cast<int>(tree.fronts.size()); ++s) {
        const Front& front = tree.fronts[s];
        std::fill_n(frontOf.begin() + front.first, front.columns, s);
    }
    return frontOf;
}

void findParents(const std::vector<int>& frontOf, FrontTree& tree) {
    tree.placeInParent.assign(tree.row.size(), -1);
    for (Front& front : tree.fronts) {
        if (front.left() == 0) {
            continue;
        }
        const int* const rows = &tree.row[front.rowStart];
        front.parent = frontOf[rows[front.columns]];
        const Front& parent = tree.fronts[front.parent];
        const int* const ofParent = &tree.row[parent.rowStart];
        int place = 0;
        for (int k = front.columns; k < front.rows; ++k) {
            while (ofParent[place] != rows[k]) {
                ++place;
                assert(place < parent.rows);
            }
            tree.placeInParent[front.rowStart + k] = place;
        }
    }
}

/// Finds the positions of the matrix's entries.
void placeEntries(const SymmetricMatrix& pattern, const std::vector<int>& frontOf,
                  FrontTree& tree) {
    std::vector<int> placeOf(tree.order.size());
    for (int k = 0; k < pattern.size; ++k) {
        placeOf[tree.order[k]] = k;
    }
    tree.place.resize(pattern.row.size());
    tree.entries = geometry::Buckets<>(static_cast<int>(tree.fronts.size()), [&](auto add) {
        for (int j = 0; j < pattern.size; ++j) {
            for (int k = pattern.columnStart[j]; k < pattern.columnStart[j + 1]; ++k) {
                add(frontOf[std::min(placeOf[j], placeOf[pattern.row[k]])], k);
            }
        }
    });
    for (int j = 0; j < pattern.size; ++j) {
        for (int k = pattern.columnStart[j]; k < pattern.columnStart[j + 1]; ++k) {
            const auto [column, row] = std::minmax(placeOf[j], placeOf[pattern.row[k]]);
            const Front& front = tree.fronts[frontOf[column]];
            const auto first = tree.row.begin() + static_cast<std::ptrdiff_t>(front.rowStart);
            const auto found = std::lower_bound(first, first + front.rows, row);
            tree.place[k] = (column - front.first) * front.rows + static_cast<int>(found - first);
        }
    }
}

/// Number of multiplications of a front.
double workOf(const Front& front) {
    const double columns = front.columns, left = front.left();
    return columns * (columns * columns / 3 + columns * left + left * left);
}

void findTasks(FrontTree& tree) {
    const int count = static_cast<int>(tree.fronts.size());
    std::vector<double> below(tree.fronts.size());  // work of a front and all below it
    std::vector<int> firstBelow(tree.fronts.size());
    double whole = 0;
    for (int s = 0; s < count; ++s) {
        below[s] += workOf(tree.fronts[s]);
        whole += workOf(tree.fronts[s]);
        firstBelow[s] = tree.children[s].empty() ? s : firstBelow[tree.children[s].front()];
        if (tree.fronts[s].parent >= 0) {
            below[tree.fronts[s].parent] += below[s];
        }
    }
    const auto isShared = [&](int s) { return s < 0 || below[s] > kWholeTask * whole; };
    std::vector<int> taskOf(tree.fronts.size(), -1);  // of the last front of each task
    for (int s = 0; s < count; ++s) {
        if (isShared(tree.fronts[s].parent) || isShared(s)) {
            taskOf[s] = static_cast<int>(tree.tasks.size());
            tree.tasks.push_back({isShared(s) ? s : firstBelow[s], s, -1, 0});
        }
    }
    for (int t = static_cast<int>(tree.tasks.size()) - 1; t >= 0; --t) {
        FrontTask& task = tree.tasks[t];
        const Front& last = tree.fronts[task.last];
        task.way = task.first == task.last ? workOf(last) : below[task.last];
        if (last.parent >= 0) {
            task.parent = taskOf[last.parent];
            task.way += tree.tasks[task.parent].way;
        }
    }
    tree.taskChildren = geometry::Buckets<>(static_cast<int>(tree.tasks.size()), [&tree](auto add) {
        for (int t = 0; t < static_cast<int>(tree.tasks.size()); ++t) {
            if (tree.tasks[t].parent >= 0) {
                add(tree.tasks[t].parent, t);
            }
        }
    });
}

/// Each task alternates between two stacks: a front at an even depth pushes its remainder on one,
/// and pops those of its children from the other.
void layStacks(FrontTree& tree) {
    std::vector<unsigned char> depth(tree.fronts.size());
    for (int s = static_cast<int>(tree.fronts.size()) - 1; s >= 0; --s) {
        const int parent = tree.fronts[s].parent;
        depth[s] = static_cast<unsigned char>(parent >= 0 && depth[parent] == 0);
    }
    for (const FrontTask& task : tree.tasks) {
        std::array<std::size_t, 2> top{}, highest{};
        for (int s = task.first; s <= task.last; ++s) {
            Front& front = tree.fronts[s];
            const int stack = depth[s];
            front.kept = top[stack];
            top[stack] += static_cast<std::size_t>(front.left()) * front.left();
            highest[stack] = std::max(highest[stack], top[stack]);
            const auto children = tree.children[s];
            if (!children.empty() && children.front() >= task.first) {
                top[1 - stack] = tree.fronts[children.front()].kept;
            }
        }
        for (int s = task.first; s <= task.last; ++s) {
            tree.fronts[s].kept += tree.workSize + (depth[s] != 0 ? highest[0] : 0);
        }
        tree.workSize += highest[0] + highest[1];
    }
}

}  // namespace

Result<FrontTree> frontTree(const SymmetricMatrix& pattern, const std::vector<int>& order) {
    FrontTree tree;
    if (const auto done = layFronts(pattern, order, tree); !done) {
        return done.error();
    }
    const std::vector<int> frontOf = frontOfPlace(tree);
    findParents(frontOf, tree);
    placeEntries(pattern, frontOf, tree);
    tree.children = geometry::Buckets<>(static_cast<int>(tree.fronts.size()), [&tree](auto add) {
        for (int s = 0; s < static_cast<int>(tree.fronts.size()); ++s) {
            if (tree.fronts[s].parent >= 0) {
                add(tree.fronts[s].parent, s);
            }
        }
    });
    findTasks(tree);
    layStacks(tree);
    return tree;
}

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
