// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/job_runner.h"

#include <QSignalBlocker>
#include <algorithm>
#include <utility>

#include "app/text/error_text.h"

namespace toile::app {

namespace {

constexpr int kPollMilliseconds = 33;

}  // namespace

JobRunner::JobRunner(QObject* parent) : QObject(parent) {
    poll_.setInterval(kPollMilliseconds);
    connect(&poll_, &QTimer::timeout, this, [this] {
        if (current_) {
            emit progressed(fraction());
        }
    });
}

JobRunner::~JobRunner() {
    shutdown();
}

bool JobRunner::isUnderWay(Ticket job) const {
    const Progress* const progress = worker_.progress();  // null: just begun
    return (current_ && current_->ticket == job && !(progress && progress->isCancelled())) ||
           std::ranges::find(waiting_, job, &Order::ticket) != waiting_.end();
}

JobRunner::Ticket JobRunner::lastUnderWay() const {
    if (!waiting_.empty()) {
        return waiting_.back().ticket;
    }
    return current_ && isUnderWay(current_->ticket) ? current_->ticket : 0;
}

QString JobRunner::title() const {
    return current_ ? current_->job->title() : QString();
}

QString JobRunner::detail() const {
    return current_ ? current_->job->detail() : QString();
}

double JobRunner::fraction() const {
    return current_ ? worker_.progress()->fraction() : 0;
}

JobRunner::Ticket JobRunner::start(std::unique_ptr<Job> job) {
    const Ticket ticket = ++last_;
    waiting_.push_back({std::move(job), ticket});
    startNext();
    return ticket;
}

JobRunner::Ticket JobRunner::replace(std::unique_ptr<Job> job) {
    cancelAll(true);
    return start(std::move(job));
}

void JobRunner::drop(Ticket job) {
    if (current_ && current_->ticket == job) {
        current_->replaced = true;
        if (current_->job->isCancellable()) {
            worker_.cancel();
        }
        return;
    }
    const auto found = std::ranges::find(waiting_, job, &Order::ticket);
    if (found != waiting_.end()) {
        const std::unique_ptr<Job> dropped = std::move(found->job);
        waiting_.erase(found);
        emit cancelled(dropped->title(), true);
    }
}

void JobRunner::cancel() {
    cancelAll(false);
}

void JobRunner::cancelAll(bool replaced) {
    if (current_) {
        current_->replaced = current_->replaced || replaced;
        if (current_->job->isCancellable()) {
            worker_.cancel();
        }
    }
    std::deque<Order> dropped;
    for (Order& waiting : std::exchange(waiting_, {})) {
        waiting.replaced = waiting.replaced || replaced;
        (waiting.job->isCancellable() ? dropped : waiting_).push_back(std::move(waiting));
    }
    for (const Order& waiting : dropped) {  // the running job announces it when it has stopped
        emit cancelled(waiting.job->title(), waiting.replaced);
    }
}

void JobRunner::shutdown() {
    const QSignalBlocker quiet(this);
    cancel();
    finish();
}

void JobRunner::finish() {
    const QSignalBlocker quiet(this);
    poll_.stop();
    worker_.stop(false);
    current_.reset();
    for (const Order& waiting : std::exchange(waiting_, {})) {
        Progress progress;
        // No listeners at shutdown.
        (void)attempt([&] { return waiting.job->process(progress); });
    }
}

void JobRunner::startNext() {
    if (current_ || waiting_.empty()) {
        return;
    }
    current_ = std::move(waiting_.front());
    waiting_.pop_front();
    poll_.start();
    emit started(current_->job->title());

    worker_.start(
        [job = current_->job.get()](Progress& progress) { return job->process(progress); },
        [this](const auto& outcome, const Progress& progress) {
            poll_.stop();
            const Order done = *std::exchange(current_, std::nullopt);
            settle(done, outcome, progress.isCancelled());
            // A slot may have started another job meanwhile.
            startNext();
            if (!current_) {
                emit idle();
            }
        });
}

void JobRunner::settle(const Order& done, const Attempt<Result<void>>& made, bool isCancelled) {
    Job& job = *done.job;
    if (made.fault) {
        emit failed(job.title(), faultText(made.fault), done.replaced);
        return;
    }
    const Result<void>& outcome = *made.answer;
    if (isCancelled || (!outcome && outcome.error().code == ErrorCode::Cancelled)) {
        emit cancelled(job.title(), done.replaced);
        return;
    }
    if (!outcome) {
        emit failed(job.title(), errorText(outcome.error()), done.replaced);
        return;
    }
    job.finalize();
}

}  // namespace toile::app
