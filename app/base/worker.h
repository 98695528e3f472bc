// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QThreadPool>
#include <QTimer>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <type_traits>
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

/// Passes the latest value from a worker to the window.
template <class Value>
class Mailbox {
public:
    void put(std::shared_ptr<const Value> value) {
        const std::lock_guard lock(mutex_);
        latest_ = std::move(value);
    }
    /// Null if there is nothing new.
    std::shared_ptr<const Value> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(latest_, nullptr);
    }

private:
    std::mutex mutex_;
    std::shared_ptr<const Value> latest_;
};

/// Keeps an answer up to date: computes the answer to the latest question on a worker thread and
/// delivers it on the GUI thread. Asking the latest question again does nothing. A new question
/// cancels work that takes a Progress and drops its answer; other work finishes, and its answer is
/// delivered as an older one. `isSameQuestion` compares questions if `==` does not fit. GUI thread
/// only.
template <class Question, class Answer>
class Follower {
public:
    /// @param isLast  nothing else has been asked since
    using Take = std::function<void(Attempt<Answer>, const Question&, bool isLast)>;
    using IsSmall = std::function<bool(const Question&)>;

    /// @param work     Answer(const Question&) or Answer(const Question&, Progress&)
    /// @param isSmall  a question that is answered at once if nothing is worked on
    /// @param pause    milliseconds to wait for another question
    template <class Work>
    Follower(Work work, Take take, IsSmall isSmall = {}, int pause = 0)
        : isCancellable_(std::is_invocable_v<Work, const Question&, Progress&>),
          take_(std::move(take)),
          isSmall_(std::move(isSmall)) {
        if constexpr (std::is_invocable_v<Work, const Question&, Progress&>) {
            work_ = std::move(work);
        } else {
            work_ = [work = std::move(work)](const Question& asked, Progress&) {
                return work(asked);
            };
        }
        pause_.setSingleShot(true);
        pause_.setInterval(pause);
        QObject::connect(&pause_, &QTimer::timeout, &pause_, [this] { start(); });
    }

    /// True until the question asked last is answered.
    bool isBusy() const { return isOpen_; }
    /// Of the work on it; null where it has not begun.
    const Progress* progress() const { return isOpen_ ? worker_.progress() : nullptr; }

    void ask(Question question) {
        if (asked_ && isSame(question, *asked_)) {
            return;
        }
        asked_ = std::move(question);
        isOpen_ = true;
        if (isCancellable_) {
            worker_.cancel();
        }
        pause_.interval() > 0 ? pause_.start() : start();
    }

    /// Nothing is asked any more, and no answer handed over.
    void forget() {
        asked_.reset();
        isOpen_ = false;
        pause_.stop();
        worker_.cancel();
    }

private:
    static bool isSame(const Question& one, const Question& other) {
        if constexpr (requires { isSameQuestion(one, other); }) {
            return isSameQuestion(one, other);
        } else {
            return one == other;
        }
    }

    void start() {
        if (!isOpen_ || worker_.isBusy() || pause_.isActive()) {
            return;  // what is worked on ends first, or another question may come
        }
        const Question question = *asked_;
        if (isSmall_ && isSmall_(question)) {
            Progress progress;
            isOpen_ = false;
            take_(attempt([&] { return work_(question, progress); }), question, true);
            return;
        }
        worker_.start(
            [work = work_, question](Progress& progress) { return work(question, progress); },
            [this, question](Attempt<Answer> made, const Progress& progress) {
                const bool isLast = asked_ && isSame(question, *asked_);
                if (!progress.isCancelled()) {
                    isOpen_ = isOpen_ && !isLast;
                    take_(std::move(made), question, isLast);
                }
                start();
            });
    }

    bool isCancellable_;
    std::function<Answer(const Question&, Progress&)> work_;
    Take take_;
    IsSmall isSmall_;
    QTimer pause_;
    std::optional<Question> asked_;
    bool isOpen_ = false;
    Worker<Answer> worker_;
};

}  // namespace toile::app
