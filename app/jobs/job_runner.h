// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <deque>
#include <memory>

#include "app/jobs/job.h"

namespace toile {

class Document;

/// Runs jobs one after the other on one worker thread. Progress is polled, not posted, so that a
/// job that reports a million times costs the window nothing. GUI thread only.
class JobRunner : public QObject {
    Q_OBJECT

public:
    explicit JobRunner(const Document& document, QObject* parent = nullptr);
    /// Cancels and waits.
    ~JobRunner() override;

    bool isBusy() const { return current_ != nullptr; }
    /// True where another job follows the one that runs, or the one just reported.
    bool hasWaiting() const { return !waiting_.empty(); }
    /// Runs the job when all earlier ones are done.
    void start(std::unique_ptr<Job> job);
    /// Cancels everything else and runs this job instead.
    void replace(std::unique_ptr<Job> job);
    /// Cancels the running job and forgets the waiting ones. Returns at once.
    void cancel();
    /// Cancels and waits for the worker: for closing the window. Nothing is finalized any more.
    void shutdown();

signals:
    void started(const QString& title);
    /// About 30 times a second while busy; fraction in [0, 1].
    void progressed(double fraction);
    void failed(const QString& title, const QString& sentence);
    void cancelled(const QString& title);
    /// The last job is over, whatever came of it.
    void idle();

private:
    struct Running;

    void startNext();
    void onFinished();
    void settle(Job& job, const Progress& progress, const Result<void>& outcome);

    const Document& document_;
    QThreadPool pool_;  ///< of one thread: jobs never overlap
    QTimer poll_;
    QFutureWatcher<void> watcher_;
    std::unique_ptr<Running> current_;
    std::deque<std::unique_ptr<Job>> waiting_;
};

}  // namespace toile
