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

/// What came of a piece of work on another thread: an answer, or what it threw instead. No
/// exception may leave a thread of Qt's: it would be thrown again in the event loop.
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

/// Does one piece of work at a time on a thread of its own, and hands over on the window's what
/// came of it. GUI thread only.
template <class Answer>
class Worker {
public:
    /// What came of the work; it may have been cancelled (`Progress::isCancelled`) and incomplete.
    using Done = std::function<void(Attempt<Answer>, const Progress&)>;

    Worker() {
        pool_.setMaxThreadCount(1);
        QObject::connect(&watcher_, &QFutureWatcherBase::finished, &watcher_, [this] {
            // The worker is free before anybody hears of it: they may have more to do.
            const std::unique_ptr<Running> done = std::move(running_);
            done->done(std::move(done->outcome), done->progress);
        });
    }
    /// Cancels and waits; nobody hears of it.
    ~Worker() { stop(); }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;

    bool isBusy() const { return running_ != nullptr; }
    /// Of the work in progress; null where there is none.
    const Progress* progress() const { return running_ ? &running_->progress : nullptr; }

    /// Precondition: not busy.
    /// @param work  Answer(Progress&), on the other thread: what it holds is the snapshot
    template <class Work>
    void start(Work work, Done done) {
        running_ = std::make_unique<Running>();
        running_->done = std::move(done);
        Running* running = running_.get();  // outlives the work, which is waited for
        watcher_.setFuture(QtConcurrent::run(&pool_, [running, work = std::move(work)]() mutable {
            running->outcome = attempt([&] { return work(running->progress); });
        }));
    }

    /// The work is to end soon; `done` is called then.
    void cancel() {
        if (running_) {
            running_->progress.cancel();
        }
    }

    /// For good: cancels, if that is wanted, and waits; `done` is not called.
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

    QThreadPool pool_;  ///< of one thread
    QFutureWatcher<void> watcher_;
    std::unique_ptr<Running> running_;
};

/// Answers questions on another thread, the last one asked first: those that come while one is
/// worked on replace each other. `isSameQuestion` says which have one answer. GUI thread only.
template <class Question, class Answer>
class Answerer {
public:
    using Work = std::function<Answer(const Question&)>;
    /// @param isLast  nothing else has been asked since
    using Take = std::function<void(Attempt<Answer>, const Question&, bool isLast)>;

    /// @param isSmall  whether a question is answered at once, where nothing is worked on
    Answerer(Work work, std::function<bool(const Question&)> isSmall, Take take)
        : work_(std::move(work)), isSmall_(std::move(isSmall)), take_(std::move(take)) {}

    bool isBusy() const { return worker_.isBusy(); }

    void ask(Question question) {
        if (asked_ && isSameQuestion(question, *asked_)) {
            next_.reset();  // what is worked on counts again
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
                          if (next_ && !isBusy()) {  // taking it may have asked something newer
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
