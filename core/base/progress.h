// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>

namespace toile {

/// The string between a long call and whoever waits for it: the worker reports, any thread may
/// read the fraction or cancel. Cancelling is sticky; the call then returns `ErrorCode::Cancelled`
/// at its next check (between pieces, solver iterations and the stages of a factorisation).
/// Thread-safe.
class Progress {
public:
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return cancelled_.load(std::memory_order_relaxed); }

    /// What is started next is a part of a longer task: it goes from fraction `from` to fraction
    /// `to` of the whole, in [0, 1]. For the one who calls several things in a row, before each.
    void setShare(double from, double to) {
        from_ = from;
        span_ = to - from;
        start(1);
    }

    /// Declares how much work there is, in any unit; `advance` counts against it.
    void start(double total) {
        const double whole = (total > 0 ? total : 1.0) / span_;
        total_.store(whole, std::memory_order_relaxed);
        done_.store(from_ * whole, std::memory_order_relaxed);
    }

    void advance(double amount) { done_.fetch_add(amount, std::memory_order_relaxed); }

    /// Fraction done, in [0, 1].
    double fraction() const {
        return std::clamp(
            done_.load(std::memory_order_relaxed) / total_.load(std::memory_order_relaxed), 0.0,
            1.0);
    }

private:
    std::atomic<bool> cancelled_{false};
    std::atomic<double> total_{1.0};
    std::atomic<double> done_{0.0};
    double from_ = 0, span_ = 1;  ///< of the whole; only the caller's thread looks at them
};

}  // namespace toile
