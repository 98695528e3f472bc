// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>

namespace toile {

/// The string between a long call and whoever waits for it: the worker reports, any thread may
/// read the fraction or cancel. Cancelling is sticky; the call then returns `ErrorCode::Cancelled`
/// at its next check (between pieces, solver iterations and the stages of a factorisation).
///
/// Who gives the order holds it as it is: may cancel, start and share out. Who does one part of the
/// work gets a `const Progress&`: may look, and `report` how far the part is, or `step` where he
/// does not know how far there is to go, as within a piece. One who calls others hands each a part
/// of his own:
///     cutter.cut(uncut[p], cuts[p], Progress(progress, 1 / count));
/// Parts may run side by side; what each adds goes to the whole at once.
///
/// The fraction never decreases but by `start` and `setShare`. Thread-safe, those two and the
/// construction aside: they come before the threads that report.
class Progress {
public:
    Progress() = default;
    /// A part of another task, `share` of it in [0, 1]: cancelled with it, and adding to its
    /// fraction what is reported here. The whole outlives its parts.
    Progress(const Progress& whole, double share) : whole_(&whole), share_(share) {}

    /// Of a part: this part alone.
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool isCancelled() const {
        return cancelled_.load(std::memory_order_relaxed) ||
               (whole_ != nullptr && whole_->isCancelled());
    }

    /// What is started next is a part of a longer task: it goes from fraction `from` to fraction
    /// `to` of the whole, in [0, 1]. For the one who calls several things in a row, before each.
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

    /// So much of this task is done, in [0, 1]. Less than reported before is passed over. Cheap:
    /// once per iteration or stage, not per triangle.
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

    /// One more stage of this task is done, of nobody knows how many: a tenth of what is left.
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
    mutable std::atomic<double> done_{0.0};  ///< a tally, no part of what a const task promises
    double from_ = 0, span_ = 1;             ///< of the longer task
    const Progress* whole_ = nullptr;
    double share_ = 1;
};

}  // namespace toile
