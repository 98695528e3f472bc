// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/ready_checker.h"

#include <QtConcurrentRun>
#include <exception>
#include <utility>

#include "app/document/document.h"
#include "core/base/progress.h"

namespace toile {

namespace {

/// Changes that come closer after each other than this are one.
constexpr int kDelayMilliseconds = 60;

constexpr DocumentChanges kMatters = DocumentChange::Garment | DocumentChange::Results |
                                     DocumentChange::Options | DocumentChange::Fabric |
                                     DocumentChange::Settings | DocumentChange::Seams |
                                     DocumentChange::Loading;

}  // namespace

/// What the worker works on: written by it, and read after the future has finished.
struct ReadyChecker::Running {
    explicit Running(CutPlan planned) : plan(std::move(planned)) {}

    CutPlan plan;
    Progress progress{};
    Readiness readiness{};
    bool isDone = false;
};

ReadyChecker::ReadyChecker(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    delay_.setSingleShot(true);
    delay_.setInterval(kDelayMilliseconds);
    connect(&delay_, &QTimer::timeout, this, &ReadyChecker::start);
    connect(&document_, &Document::changed, this, &ReadyChecker::onChanged);
    connect(&watcher_, &QFutureWatcherBase::finished, this, &ReadyChecker::onFinished);
    plan_ = planOfDocument();
    if (plan_.garment) {
        delay_.start();
    }
}

ReadyChecker::~ReadyChecker() {
    watcher_.disconnect(this);
    if (running_) {
        running_->progress.cancel();
    }
    watcher_.waitForFinished();
}

void ReadyChecker::setGuessesKept(bool kept) {
    if (kept != guessesKept_) {
        guessesKept_ = kept;
        delay_.start();
    }
}

void ReadyChecker::onChanged(DocumentChanges what) {
    if (!(what & kMatters)) {
        return;
    }
    if (running_) {
        running_->progress.cancel();
    }
    if (!document_.garment() && plan_.garment) {
        plan_ = {};
        readiness_ = {};
        emit changed();
    }
    delay_.start();
}

CutPlan ReadyChecker::planOfDocument() const {
    return {.garment = document_.garment(),
            .results = document_.results(),
            .options = document_.options(),
            .fabric = document_.fabric(),
            .settings = document_.settings(),
            .guessesKept = guessesKept_};
}

void ReadyChecker::start() {
    if (running_) {
        return;  // it has been cancelled, and then this comes again
    }
    CutPlan plan = planOfDocument();
    if (plan == plan_) {
        return;
    }
    running_ = std::make_unique<Running>(std::move(plan));
    Running* running = running_.get();  // outlives the future: the destructor waits for it
    watcher_.setFuture(QtConcurrent::run([running] {
        try {
            running->readiness = readyToCut(running->plan, running->progress);
            running->isDone = !running->progress.isCancelled();
        } catch (const std::exception&) {
            // Out of memory: what was known before is shown on, and the next change asks again.
        }
    }));
}

void ReadyChecker::onFinished() {
    const std::unique_ptr<Running> done = std::move(running_);
    const bool isLost = !done->isDone && !done->progress.isCancelled();
    if (done->isDone) {
        plan_ = std::move(done->plan);
        readiness_ = std::move(done->readiness);
        emit changed();
    }
    // What has changed while this ran may have been asked for in vain.
    if (!isLost && !running_ && !(planOfDocument() == plan_)) {
        delay_.start();
    }
}

}  // namespace toile
