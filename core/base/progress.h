// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>

namespace toile {

/// Wall-clock seconds since its construction.
class Stopwatch {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Connects a long call with its caller: the worker reports, any thread may read the fraction or
/// cancel. Cancelling is sticky; the call then returns `ErrorCode::Cancelled` at its next check
/// (between pieces, solver iterations and the stages of a factorisation).
///
/// The owner of a task holds a non-const Progress and may cancel, start and divide it. A part of
/// the work gets a `const Progress&`: it may check for cancellation and `report` its fraction, or
/// `step` if the amount of work is unknown, as within a piece. A function that calls others gives
/// each a part of its own:
///     cutter.cut(uncut[p], cuts[p], Progress(progress, 1 / count));
/// Parts may run in parallel; what each adds counts for the whole at once.
///
/// The fraction only decreases by `start` and `setShare`. Thread-safe, except for those two and the
/// construction, which must come before the threads that report.
class Progress {
public:
    Progress() = default;
    /// A part of another task, `share` of it in [0, 1]: cancelled with it, and its progress is
    /// added to the other's fraction. The whole must outlive its parts.
    Progress(const Progress& whole, double share) : whole_(&whole), share_(share) {}

    /// On a part, cancels this part alone.
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool isCancelled() const {
        return cancelled_.load(std::memory_order_relaxed) ||
               (whole_ != nullptr && whole_->isCancelled());
    }

    /// The next task to start is a part of a longer one: it covers the fractions `from` to `to` of
    /// the whole, in [0, 1]. Call it before each of several calls in a row.
    void setShare(double from, double to) {
        from_ = from;
        span_ = to - from;
        start(1);
    }

    /// Declares how much work there is, in any unit; `advance` counts against it.
    void start(double total) {
        unit_.store(span_ / (total > 0 ? total : 1.0), std::memory_order_relaxed);
        done_.store(from_, std::memory_order_relaxed);
    }

    void advance(double amount) const { add(amount * unit_.load(std::memory_order_relaxed)); }

    /// The fraction of this task that is done, in [0, 1]. Values below the last report are ignored.
    /// Cheap: call once per iteration or stage, not per triangle.
    void report(double fractionOfThisPiece) const {
        const double now = from_ + span_ * std::min(fractionOfThisPiece, 1.0);
        double before = done_.load(std::memory_order_relaxed);
        while (before < now) {
            if (done_.compare_exchange_weak(before, now, std::memory_order_relaxed)) {
                passOn(now - before);
                return;
            }
        }
    }

    /// One of an unknown number of stages is done: adds a tenth of the rest.
    void step() const {
        const double done = (done_.load(std::memory_order_relaxed) - from_) / span_;
        report(done + (1 - done) / 10);
    }

    /// Fraction done, in [0, 1].
    double fraction() const { return std::clamp(done_.load(std::memory_order_relaxed), 0.0, 1.0); }

private:
    void add(double fraction) const {
        done_.fetch_add(fraction, std::memory_order_relaxed);
        passOn(fraction);
    }

    void passOn(double fraction) const {
        if (whole_ != nullptr) {
            whole_->add(fraction * share_ * whole_->span_);
        }
    }

    std::atomic<bool> cancelled_{false};
    std::atomic<double> unit_{1.0};          ///< fraction per unit of `advance`
    mutable std::atomic<double> done_{0.0};  ///< a counter, not part of a task's logical state
    double from_ = 0, span_ = 1;             ///< of the longer task
    const Progress* whole_ = nullptr;
    double share_ = 1;
};

}  // namespace toile
