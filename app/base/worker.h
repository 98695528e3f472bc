// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QThreadPool>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include <QtConcurrent/QtConcurrentRun>

#include "core/base/progress.h"

namespace toile::app {

/// Outcome of work on another thread: an answer, or the exception thrown. Exceptions must not leave
/// a QtConcurrent thread: Qt would rethrow them in the event loop.
template <class Answer>
struct Attempt {
    std::optional<Answer> answer{};
    std::exception_ptr fault{};
};

template <class Work>
auto attempt(const Work& work) -> Attempt<decltype(work())> {
    try {
        return {work(), nullptr};
    } catch (const std::exception&) {
        return {std::nullopt, std::current_exception()};
    }
}

/// Does one piece of work at a time on its own thread and delivers the outcome on the GUI thread.
/// GUI thread only.
template <class Answer>
class Worker {
public:
    /// Gets the outcome, incomplete if the work was cancelled (`Progress::isCancelled`).
    using Done = std::function<void(Attempt<Answer>, const Progress&)>;

    Worker() {
        pool_.setMaxThreadCount(1);
        QObject::connect(&watcher_, &QFutureWatcherBase::finished, &watcher_, [this] {
            // Become idle before calling `done`, which may start more work.
            const std::unique_ptr<Running> done = std::move(running_);
            done->done(std::move(done->outcome), done->progress);
        });
    }
    /// Cancels and waits without calling `done`.
    ~Worker() { stop(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    bool isBusy() const { return running_ != nullptr; }
    /// Progress of the current work; null if idle.
    const Progress* progress() const { return running_ ? &running_->progress : nullptr; }

    /// Precondition: not busy.
    /// @param work  Answer(Progress&), run on the other thread on captured snapshots
    template <class Work>
    void start(Work work, Done done) {
        running_ = std::make_unique<Running>();
        running_->done = std::move(done);
        Running* running = running_.get();  // outlives the work: `stop` waits
        watcher_.setFuture(QtConcurrent::run(&pool_, [running, work = std::move(work)]() mutable {
            running->outcome = attempt([&] { return work(running->progress); });
        }));
    }

    /// Asks the work to end; `done` is called then.
    void cancel() {
        if (running_) {
            running_->progress.cancel();
        }
    }

    /// Waits, optionally after cancelling; `done` is never called.
    void stop(bool cancelling = true) {
        watcher_.disconnect();
        if (cancelling) {
            cancel();
        }
        watcher_.waitForFinished();
        running_.reset();
    }

private:
    struct Running {
        Progress progress;
        Attempt<Answer> outcome;
        Done done;
    };

    QThreadPool pool_;  ///< with one thread
    QFutureWatcher<void> watcher_;
    std::unique_ptr<Running> running_;
};

/// Answers questions on another thread, latest first: a new question replaces a waiting one.
/// `isSameQuestion` tells which have the same answer. GUI thread only.
template <class Question, class Answer>
class Answerer {
public:
    using Work = std::function<Answer(const Question&)>;
    /// @param isLast  no other question is waiting
    using Take = std::function<void(Attempt<Answer>, const Question&, bool isLast)>;

    /// @param isSmall  whether to answer at once, if idle
    Answerer(Work work, std::function<bool(const Question&)> isSmall, Take take)
        : work_(std::move(work)), isSmall_(std::move(isSmall)), take_(std::move(take)) {}

    bool isBusy() const { return worker_.isBusy(); }

    void ask(Question question) {
        if (asked_ && isSameQuestion(question, *asked_)) {
            next_.reset();  // the work in progress answers it
        } else if (isBusy()) {
            next_ = std::move(question);
        } else {
            start(std::move(question));
        }
    }

private:
    void start(Question question) {
        asked_ = question;
        next_.reset();
        if (isSmall_(question)) {
            take_(attempt([this, &question] { return work_(question); }), question, true);
            return;
        }
        worker_.start([work = work_, question](Progress&) { return work(question); },
                      [this, question](Attempt<Answer> made, const Progress&) {
                          take_(std::move(made), question, !next_);
                          if (next_ && !isBusy()) {  // `take_` may have asked a newer question
                              ask(*std::exchange(next_, std::nullopt));
                          }
                      });
    }

    Work work_;
    std::function<bool(const Question&)> isSmall_;
    Take take_;
    std::optional<Question> asked_, next_;
    Worker<Answer> worker_;
};

}  // namespace toile::app
