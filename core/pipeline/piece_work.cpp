// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pipeline/piece_work.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <numeric>
#include <thread>
#include <utility>

#include "core/base/abandonable_threads.h"
#include "core/base/stopwatch.h"
#include "core/flatten/flat_notes.h"
#include "core/garment/piece.h"

namespace toile {
namespace {

/// Between two looks at the caller's progress while the workers are busy.
constexpr std::chrono::milliseconds kLookEvery{5};
/// Of a piece's time, about; the rest is measuring.
constexpr double kFlatteningShare = 0.95;
/// What the caller sees at most until all is done: the tally of the pieces' parts may round to 1
/// before.
constexpr double kNearlyDone = 0.999;

std::shared_ptr<PieceResult> emptyResult(const std::shared_ptr<const Piece>& piece,
                                         const FlattenOptions& options) {
    auto result = std::make_shared<PieceResult>();
    result->piece = piece;
    result->options = options;
    return result;
}

DoneTask cancelledTask(const std::shared_ptr<const Piece>& piece, const FlattenOptions& options) {
    auto result = emptyResult(piece, options);
    result->error = Error{ErrorCode::Cancelled, piece->name, ""};
    return {std::move(result)};
}

DoneTask flattenOne(const PieceTask& task, const FlattenOptions& options,
                    const Progress& progress) {
    const Stopwatch time;
    const std::shared_ptr<const Piece>& piece = task.piece;
    auto result = emptyResult(piece, options);
    std::optional<PieceFlattener> flattener = task.flattener;
    try {
        const Progress part(progress, kFlatteningShare);
        auto flat =
            flattener ? flattener->flatten(piece, options, part) : flatten(*piece, options, part);
        if (flat) {
            nameCrossingCut(*piece, flat->Q, progress, flat->notes);
        }
        if (progress.isCancelled()) {
            return cancelledTask(piece, options);
        }
        progress.report(kFlatteningShare);
        if (flat) {
            result->quality = measure(*piece, flat->Q);
            result->flat = std::move(*flat);
        } else {
            result->error = flat.error();
        }
    } catch (const std::bad_alloc&) {  // one piece too large must not end the others' thread
        result->flat.reset();
        result->quality.reset();
        result->error = Error{ErrorCode::OutOfMemory, piece->name, ""};
    }
    result->seconds = time.seconds();
    progress.report(1);
    return {std::move(result), std::move(flattener)};
}

/// The work and all it needs, owned by the caller and the workers together: whoever leaves last
/// clears it away.
class Work {
public:
    Work(std::vector<PieceTask> tasks, const FlattenOptions& options)
        : tasks_(std::move(tasks)), options_(options), order_(tasks_.size()), done_(tasks_.size()) {
        // Largest first, so that no thread is left alone with a big piece at the end. Each result
        // goes to its own place: the order of work leaves no trace.
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(),
                         [this](std::size_t a, std::size_t b) { return size(a) > size(b); });
        for (const std::size_t k : order_) {
            total_ += size(k);
        }
    }

    /// What a worker does: one piece after the other, until there is none or all are cancelled.
    void run() {
        try {
            for (std::size_t k = next_++; k < order_.size() && !progress_.isCancelled();
                 k = next_++) {
                const std::size_t task = order_[k];
                const Progress part(progress_, size(task) / total_);
                auto done = flattenOne(tasks_[task], options_, part);
                const std::lock_guard lock(mutex_);
                done_[task] = std::move(done);
                ++finished_;
                changed_.notify_one();
            }
        } catch (...) {  // a bug: the caller's to report, on the caller's thread
            const std::lock_guard lock(mutex_);
            failure_ = std::current_exception();
            changed_.notify_one();
        }
    }

    /// Waits for the workers and passes on what they report.
    /// @return false where the caller has cancelled: they are told, and may still be busy
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

    /// Those done; where the work was cancelled the others say so.
    std::vector<DoneTask> done() {
        std::vector<DoneTask> done;
        {
            const std::lock_guard lock(mutex_);
            done = done_;
        }
        for (std::size_t k = 0; k < done.size(); ++k) {
            if (!done[k].result) {
                done[k] = cancelledTask(tasks_[k].piece, options_);
            }
        }
        return done;
    }

private:
    double size(std::size_t task) const {
        return 1.0 + static_cast<double>(tasks_[task].piece->mesh.F.rows());
    }

    const std::vector<PieceTask> tasks_;
    const FlattenOptions options_;
    std::vector<std::size_t> order_;
    double total_ = 0;
    Progress progress_;  ///< the workers' own: the caller's may be gone when they look
    std::atomic<std::size_t> next_{0};

    std::mutex mutex_;  ///< of what follows
    std::condition_variable changed_;
    std::vector<DoneTask> done_;
    std::size_t finished_ = 0;
    std::exception_ptr failure_;
};

int coreCount() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Waits while what was abandoned earlier has all the cores, and its memory: else cancelling again
/// and again would heap up work.
/// @return false where the caller has cancelled
bool waitForACore(const Progress& progress) {
    while (!progress.isCancelled() && AbandonableThreads::stillRunning() >= coreCount()) {
        std::this_thread::sleep_for(kLookEvery);
    }
    return !progress.isCancelled();
}

/// Cores for this work. What was abandoned earlier still has its own.
int threadCount(int threads) {
    return std::max(1, threads > 0 ? threads : coreCount() - AbandonableThreads::stillRunning());
}

}  // namespace

std::vector<DoneTask> workOn(std::vector<PieceTask> tasks, const FlattenOptions& options,
                             Progress& progress, int threads) {
    progress.start(1);
    const std::size_t count = tasks.size();
    const auto work = std::make_shared<Work>(std::move(tasks), options);
    AbandonableThreads workers;  // on the way out left alone, if they have not ended
    const bool goesOn = count > 0 && waitForACore(progress);
    const std::size_t wanted =
        goesOn ? std::min(count, static_cast<std::size_t>(threadCount(threads))) : 0;
    std::size_t running = 0;
    while (running < wanted && workers.start([work] { work->run(); })) {
        ++running;
    }
    if (running == 0 && wanted > 0) {
        work->run();  // no thread to be had: then here, and a cancel comes too late
    }
    if (work->wait(progress)) {
        workers.join();
        progress.report(1);
    }
    return work->done();
}

}  // namespace toile
