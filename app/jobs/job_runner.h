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

/// Runs jobs one after the other on one worker thread. Progress is polled, not posted, so that a
/// job that reports a million times costs the window nothing. GUI thread only.
class JobRunner : public QObject {
    Q_OBJECT

public:
    explicit JobRunner(QObject* parent = nullptr);
    /// Cancels and waits.
    ~JobRunner() override;

    /// Which job; none has 0.
    using Ticket = std::uint64_t;

    bool isBusy() const { return current_.has_value(); }
    bool hasWaiting() const { return !waiting_.empty(); }
    /// Whether that job runs or waits, and is not cancelled.
    bool isUnderWay(Ticket job) const;
    /// The last that was asked for and is under way; 0: none.
    Ticket lastUnderWay() const;
    /// Of the running job; empty where none runs.
    QString title() const;
    /// What more is known of it; may be empty.
    QString detail() const;
    /// Of the running job, in [0, 1].
    double fraction() const;
    /// Runs the job when all earlier ones are done.
    Ticket start(std::unique_ptr<Job> job);
    /// Cancels everything else and runs this job instead.
    Ticket replace(std::unique_ptr<Job> job);
    /// Cancels the running job and the waiting ones. Returns at once.
    void cancel();
    /// Cancels that job alone, because what it was to find is not wanted any more; nothing where it
    /// is over. Returns at once.
    void drop(Ticket job);
    /// Cancels and waits for the worker: for closing the window. Jobs that cannot be cancelled are
    /// done, the waiting ones too, here; nothing is finalized any more.
    void shutdown();
    /// The same without cancelling: all jobs are done, here.
    void finish();

signals:
    void started(const QString& title);
    /// About 30 times a second while busy; fraction in [0, 1].
    void progressed(double fraction);
    /// @param replaced  another job has been asked for in its place, or in that of those around it,
    ///                  or it was dropped
    void failed(const QString& title, const QString& sentence, bool replaced);
    void cancelled(const QString& title, bool replaced);
    /// The last job is over, whatever came of it.
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
