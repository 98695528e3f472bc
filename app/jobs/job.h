// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace toile::app {

/// A slow piece of work. It takes a snapshot when it is made (GUI thread), works only on that, and
/// delivers its result at the end. Made, finalized and destroyed on the GUI thread.
class Job {
public:
    virtual ~Job() = default;

    /// For the status bar, for example "Reading tee.obj".
    virtual QString title() const = 0;
    /// Details known so far, for example "12,000 faces"; may be empty.
    virtual QString detail() const { return {}; }
    /// False if the work is short and half of it is worse than none: cancelling has no effect.
    virtual bool isCancellable() const { return true; }
    /// The work, on a worker thread: it touches no widget and no document, polls `progress` and
    /// returns Cancelled if cancelled. May throw only for bugs and lack of memory.
    virtual Result<void> process(Progress& progress) = 0;
    /// Delivers the result, on the GUI thread, only if `process` returned without an error.
    virtual void finalize() = 0;
};

/// A job of two functions; see `makeJob`.
template <class Work, class Done>
class FunctionJob : public Job {
public:
    FunctionJob(QString title, Work work, Done done, bool isCancellable,
                std::function<QString()> detail)
        : title_(std::move(title)),
          work_(std::move(work)),
          done_(std::move(done)),
          isCancellable_(isCancellable),
          detail_(std::move(detail)) {}

    QString title() const override { return title_; }
    QString detail() const override { return detail_ ? detail_() : QString(); }
    bool isCancellable() const override { return isCancellable_; }
    Result<void> process(Progress& progress) override {
        auto made = work_(progress);
        if (!made) {
            return made.error();
        }
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        made_ = std::move(made).value();
        return {};
    }
    void finalize() override { done_(*std::move(made_)); }

private:
    using Outcome = std::invoke_result_t<Work&, Progress&>;

    QString title_;
    Work work_;
    Done done_;
    bool isCancellable_;
    std::function<QString()> detail_;
    std::optional<std::decay_t<decltype(std::declval<Outcome&>().value())>> made_;
};

/// @param work  `Result<Made>(Progress&)`: the work, which holds the snapshot. May return anything
///              once cancelled
/// @param done  `void(Made)`: receives the result
/// @param detail  called on the GUI thread while the job exists
template <class Work, class Done>
std::unique_ptr<Job> makeJob(QString title, Work work, Done done, bool isCancellable = true,
                             std::function<QString()> detail = {}) {
    return std::make_unique<FunctionJob<Work, Done>>(
        std::move(title), std::move(work), std::move(done), isCancellable, std::move(detail));
}

}  // namespace toile::app
