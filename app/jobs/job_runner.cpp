// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/job_runner.h"

#include <QtConcurrentRun>
#include <exception>
#include <string>
#include <utility>

#include "app/document/document.h"

namespace toile {

namespace {

constexpr int kPollMilliseconds = 33;

}  // namespace

/// The job on the worker and what comes back from it. `outcome` and `crash` are written by the
/// worker and read after the future has finished, which orders the two.
struct JobRunner::Running {
    std::unique_ptr<Job> job;
    Progress progress;
    Result<void> outcome;
    std::string crash;
};

JobRunner::JobRunner(const Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    pool_.setMaxThreadCount(1);
    poll_.setInterval(kPollMilliseconds);
    connect(&poll_, &QTimer::timeout, this, [this] {
        if (current_) {
            emit progressed(current_->progress.fraction());
        }
    });
    connect(&watcher_, &QFutureWatcher<void>::finished, this, &JobRunner::onFinished);
}

JobRunner::~JobRunner() {
    shutdown();
}

void JobRunner::start(std::unique_ptr<Job> job) {
    waiting_.push_back(std::move(job));
    startNext();
}

void JobRunner::replace(std::unique_ptr<Job> job) {
    cancel();
    start(std::move(job));
}

void JobRunner::cancel() {
    std::erase_if(waiting_, [](const auto& job) { return job->isCancellable(); });
    if (current_ && current_->job->isCancellable()) {
        current_->progress.cancel();
    }
}

void JobRunner::shutdown() {
    cancel();
    waiting_.clear();
    watcher_.disconnect(this);
    poll_.stop();
    watcher_.waitForFinished();
    current_.reset();
}

void JobRunner::startNext() {
    if (current_ || waiting_.empty()) {
        return;
    }
    current_ = std::make_unique<Running>();
    current_->job = std::move(waiting_.front());
    waiting_.pop_front();
    poll_.start();
    emit started(current_->job->title());

    Running* running = current_.get();  // outlives the future: shutdown waits for it
    watcher_.setFuture(QtConcurrent::run(&pool_, [running] {
        try {
            running->outcome = running->job->process(running->progress);
        } catch (const std::exception& exception) {
            running->crash = exception.what();
        }
    }));
}

void JobRunner::onFinished() {
    poll_.stop();
    const std::unique_ptr<Running> done = std::move(current_);
    if (!done->crash.empty()) {
        emit failed(done->job->title(), tr("The program met an unexpected fault (%1). Please "
                                           "report it with the garment file.")
                                            .arg(QString::fromStdString(done->crash)));
    } else {
        settle(*done->job, done->progress, done->outcome);
    }
    // A slot may have started another job meanwhile.
    startNext();
    if (!current_) {
        emit idle();
    }
}

void JobRunner::settle(Job& job, const Progress& progress, const Result<void>& outcome) {
    if (progress.isCancelled() || (!outcome && outcome.error().code == ErrorCode::Cancelled)) {
        emit cancelled(job.title());
        return;
    }
    if (!outcome) {
        emit failed(job.title(), QString::fromStdString(sentence(outcome.error())));
        return;
    }
    const bool stale = job.revision() && *job.revision() != document_.revision();
    if (!stale) {
        job.finalize();
    }
}

}  // namespace toile
