// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/piece_work.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <future>
#include <iterator>
#include <mutex>
#include <new>
#include <numeric>
#include <system_error>
#include <thread>
#include <utility>

#include "core/base/id.h"
#include "core/base/progress.h"
#include "core/diagnose/crossing_cut.h"
#include "core/flatten/base/outline_targets.h"
#include "core/garment/piece.h"
#include "core/pattern/drawn_outline.h"

namespace toile {
namespace {

/// Interval between two polls of the caller's progress while the workers are busy.
constexpr std::chrono::milliseconds kLookEvery{5};
/// Approximate share of a piece's time; measuring takes the rest.
constexpr double kFlatteningShare = 0.95;
/// Upper limit of the reported progress until all is done: rounded parts may add up to 1 earlier.
constexpr double kNearlyDone = 0.999;

std::uint64_t fingerprintOf(const Points2& Q) {
    return contentHash({reinterpret_cast<const char*>(Q.data()),
                        static_cast<std::size_t>(Q.size()) * sizeof(double)});
}

std::shared_ptr<PieceResult> emptyResult(const PieceTask& task, const FlattenOptions& options) {
    auto result = std::make_shared<PieceResult>();
    result->piece = task.piece;
    result->options = task.exact ? task.exact->options : options;
    result->targets = task.targets;
    result->cloth = task.cloth;
    result->exact = task.exact;
    result->plan = task.plan;
    return result;
}

DoneTask cancelledTask(const PieceTask& task, const FlattenOptions& options) {
    auto result = emptyResult(task, options);
    result->error = Error{ErrorCode::Cancelled, subjectOf(*task.piece)};
    return {std::move(result)};
}

/// Stores the flat piece with its figures.
void take(PieceResult& result, FlatPiece flat) {
    result.quality = measure(*result.piece, flat.Q);
    measureOutline(*result.piece, flat, result.targets, *result.quality);
    result.fingerprint = fingerprintOf(flat.Q);
    result.flat = std::move(flat);
}

void flattenInto(PieceResult& result, std::optional<PieceFlattener>& flattener,
                 const Progress& progress) {
    const Progress part(progress, kFlatteningShare);
    auto flat =
        flattener
            ? flattener->flatten(result.piece, result.options, part, result.targets, result.cloth)
            : flatten(*result.piece, result.options, part, result.targets, result.cloth);
    if (!flat) {
        result.error = flat.error();
        return;
    }
    nameCrossingCut(*result.piece, flat->Q, std::exchange(flat->crossings, {}), progress,
                    flat->notes);
    if (!progress.isCancelled()) {
        take(result, std::move(*flat));
    }
}

/// Draws the line and solves the interior inside it.
Result<FlatPiece> drawn(const Piece& piece, const PieceResult& exact, const OutlinePlan& plan,
                        const Progress& progress) {
    auto line = drawnOutline(piece, *exact.flat, plan, progress);
    if (!line) {
        return line.error();
    }
    auto flat = flattenInside(piece, *exact.flat, verticesOn(*line, piece), exact.options,
                              Progress(progress, kFlatteningShare), exact.cloth);
    if (flat) {
        if (line->hasYielded) {
            flat->notes.push_back({ErrorCode::LineYields, subjectOf(piece)});
        }
        if (plan.stated > 0 && line->farthest > plan.stated) {
            flat->notes.push_back({ErrorCode::LineStrays, subjectOf(piece),
                                   worded("up to %1 mm from the exact outline, not %2 mm",
                                          {figure(line->farthest, 1), figure(plan.stated, 1)})});
        }
        flat->line = std::make_shared<const FlatLine>(std::move(*line));
    }
    return flat;
}

void drawInto(PieceResult& result, const Progress& progress) {
    auto flat = drawn(*result.piece, *result.exact, *result.plan, progress);
    if (flat) {
        nameCrossingCut(*result.piece, flat->Q, std::exchange(flat->crossings, {}), progress,
                        flat->notes);
        take(result, std::move(*flat));
    } else if (flat.error().code == ErrorCode::Cancelled) {
        result.error = flat.error();
    } else {  // the exact piece can still be cut and sewn
        FlatPiece exact = *result.exact->flat;
        exact.notes.push_back(
            Error{ErrorCode::LineNotDrawn, subjectOf(*result.piece), flat.error().detail});
        take(result, std::move(exact));
    }
}

DoneTask doOne(const PieceTask& task, const FlattenOptions& options, const Progress& progress) {
    const Stopwatch time;
    auto result = emptyResult(task, options);
    std::optional<PieceFlattener> flattener = task.flattener;
    try {
        if (task.exact) {
            drawInto(*result, progress);
        } else {
            flattenInto(*result, flattener, progress);
        }
        if (progress.isCancelled()) {
            return cancelledTask(task, options);
        }
    } catch (const std::bad_alloc&) {  // a piece that is too large must not stop the other pieces
        result->flat.reset();
        result->quality.reset();
        result->error = Error{ErrorCode::OutOfMemory, subjectOf(*task.piece)};
    }
    result->seconds = time.seconds() + (task.exact ? task.exact->seconds : 0);
    progress.report(1);
    return {std::move(result), std::move(flattener)};
}

/// The work and all its data, owned by the caller and the workers together; the last owner frees
/// it.
class Work {
public:
    Work(std::vector<PieceTask> tasks, const FlattenOptions& options, OnPiece onPiece)
        : tasks_(std::move(tasks)),
          options_(options),
          onPiece_(std::move(onPiece)),
          order_(tasks_.size()),
          done_(tasks_.size()) {
        // Largest first, so that no thread is left alone with a big piece at the end. The order
        // does not affect results: each has its own slot.
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(),
                         [this](std::size_t a, std::size_t b) { return size(a) > size(b); });
        for (const std::size_t k : order_) {
            total_ += size(k);
        }
    }

    /// A worker's loop: takes tasks until all are taken or cancelled.
    void run() {
        try {
            for (std::size_t k = next_++; k < order_.size() && !progress_.isCancelled();
                 k = next_++) {
                const std::size_t task = order_[k];
                const Progress part(progress_, size(task) / total_);
                tell(task);
                auto done = doOne(tasks_[task], options_, part);
                const std::lock_guard lock(mutex_);
                done_[task] = std::move(done);
                ++finished_;
                changed_.notify_one();
            }
        } catch (...) {  // a bug: rethrown on the caller's thread
            const std::lock_guard lock(mutex_);
            failure_ = std::current_exception();
            changed_.notify_one();
        }
    }

    /// Waits for the workers and passes their reports on.
    /// @return false if the caller has cancelled: the workers know, and may still be busy
    bool wait(const Progress& progress) {
        std::unique_lock lock(mutex_);
        while (finished_ < tasks_.size() && !failure_) {
            if (progress.isCancelled()) {
                progress_.cancel();
                return false;
            }
            changed_.wait_for(lock, kLookEvery);
            progress.report(std::min(progress_.fraction(), kNearlyDone));
        }
        if (failure_) {
            progress_.cancel();
            std::rethrow_exception(failure_);
        }
        return true;
    }

    /// The finished tasks; unfinished ones of a cancelled run carry Cancelled.
    std::vector<DoneTask> done() {
        std::vector<DoneTask> done;
        {
            const std::lock_guard lock(mutex_);
            done = done_;
        }
        for (std::size_t k = 0; k < done.size(); ++k) {
            if (!done[k].result) {
                done[k] = cancelledTask(tasks_[k], options_);
            }
        }
        return done;
    }

private:
    void tell(std::size_t task) {
        if (onPiece_) {
            const std::lock_guard lock(mutex_);
            onPiece_(static_cast<int>(finished_), static_cast<int>(tasks_.size()),
                     *tasks_[task].piece);
        }
    }

    double size(std::size_t task) const {
        return 1.0 + static_cast<double>(tasks_[task].piece->mesh.F.rows());
    }

    const std::vector<PieceTask> tasks_;
    const FlattenOptions options_;
    const OnPiece onPiece_;
    std::vector<std::size_t> order_;
    double total_ = 0;
    Progress progress_;  ///< the workers' own: the caller's may be destroyed while they run
    std::atomic<std::size_t> next_{0};

    std::mutex mutex_;  ///< guards the members below
    std::condition_variable changed_;
    std::vector<DoneTask> done_;
    std::size_t finished_ = 0;
    std::exception_ptr failure_;
};

int coreCount() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

bool hasEnded(const std::future<void>& worker) {
    return worker.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// Waits while ending workers use all cores. Otherwise repeated cancelling would pile up work and
/// memory.
/// @return false if the caller has cancelled
bool waitForACore(const EndingWorkers* ending, const Progress& progress) {
    while (!progress.isCancelled() && ending != nullptr && ending->count() >= coreCount()) {
        std::this_thread::sleep_for(kLookEvery);
    }
    return !progress.isCancelled();
}

}  // namespace

void EndingWorkers::take(std::vector<std::future<void>> more) {
    const std::lock_guard lock(mutex_);
    std::erase_if(workers_, hasEnded);
    std::ranges::move(more, std::back_inserter(workers_));
}

int EndingWorkers::count() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(std::ranges::count_if(
        workers_, [](const std::future<void>& worker) { return !hasEnded(worker); }));
}

std::vector<DoneTask> workOn(std::vector<PieceTask> tasks, const FlattenOptions& options,
                             Progress& progress, int threads, EndingWorkers* ending,
                             OnPiece onPiece) {
    progress.start(1);
    const std::size_t count = tasks.size();
    const auto work = std::make_shared<Work>(std::move(tasks), options, std::move(onPiece));
    std::vector<std::future<void>> workers;
    if (count > 0 && waitForACore(ending, progress)) {
        const int busy = ending != nullptr ? ending->count() : 0;
        const int cores = threads > 0 ? threads : coreCount() - busy;
        const std::size_t wanted = std::min(count, static_cast<std::size_t>(std::max(1, cores)));
        try {
            while (workers.size() < wanted) {
                workers.push_back(std::async(std::launch::async, [work] { work->run(); }));
            }
        } catch (const std::system_error&) {  // the system has no more threads
            if (workers.empty()) {
                work->run();  // so run it here; cancelling is not possible then
            }
        }
    }
    const bool isDone = work->wait(progress);
    if (!isDone && ending != nullptr) {
        ending->take(std::move(workers));
    }
    workers.clear();  // waits for those that remain
    if (isDone) {
        progress.report(1);
    }
    return work->done();
}

}  // namespace toile
