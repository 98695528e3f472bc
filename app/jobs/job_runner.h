// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "app/base/worker.h"
#include "app/jobs/job.h"

namespace toile::app {

/// Runs jobs one after the other on one worker thread. Progress is polled, so that frequent reports
/// do not slow the window down. GUI thread only.
class JobRunner : public QObject {
    Q_OBJECT

public:
    explicit JobRunner(QObject* parent = nullptr);
    /// Cancels and waits.
    ~JobRunner() override;

    /// Identifies a job; never 0.
    using Ticket = std::uint64_t;

    bool isBusy() const { return current_.has_value(); }
    bool hasWaiting() const { return !waiting_.empty(); }
    /// True if the job runs or waits, and is not cancelled.
    bool isUnderWay(Ticket job) const;
    /// The job asked for last that is under way; 0: none.
    Ticket lastUnderWay() const;
    /// Title of the running job; empty if none runs.
    QString title() const;
    /// Details about it; may be empty.
    QString detail() const;
    /// Progress of the running job, in [0, 1].
    double fraction() const;
    /// Runs the job when all earlier ones are done.
    Ticket start(std::unique_ptr<Job> job);
    /// Cancels everything else and runs this job instead.
    Ticket replace(std::unique_ptr<Job> job);
    /// Cancels the running job and the waiting ones. Returns at once.
    void cancel();
    /// Cancels one job whose result is not wanted any more; nothing if it has ended. Returns at
    /// once.
    void drop(Ticket job);
    /// Cancels and waits for the worker, for closing the window. Jobs that cannot be cancelled are
    /// completed, waiting ones here; nothing is finalized any more.
    void shutdown();
    /// The same without cancelling: all jobs are completed.
    void finish();

signals:
    void started(const QString& title);
    /// About 30 times a second while busy; fraction in [0, 1].
    void progressed(double fraction);
    /// @param replaced  another job was asked for instead, or it was dropped
    void failed(const QString& title, const QString& sentence, bool replaced);
    void cancelled(const QString& title, bool replaced);
    /// The last job has ended, whatever its result.
    void idle();

private:
    struct Order {
        std::unique_ptr<Job> job;
        Ticket ticket = 0;
        bool replaced = false;
    };

    void startNext();
    void cancelAll(bool replaced);
    void settle(const Order& done, const Attempt<Result<void>>& made, bool isCancelled);

    QTimer poll_;
    Worker<Result<void>> worker_;   ///< jobs never overlap
    std::optional<Order> current_;  ///< on the worker
    std::deque<Order> waiting_;
    Ticket last_ = 0;
};

}  // namespace toile::app
