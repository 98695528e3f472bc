// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/ready_checker.h"

#include <utility>

#include "app/document/document.h"
#include "app/document/shown_proof.h"
#include "core/base/file.h"

namespace toile::app {

namespace {

/// Changes that come closer after each other than this are one.
constexpr int kDelayMilliseconds = 60;

}  // namespace

ReadyChecker::ReadyChecker(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    delay_.setSingleShot(true);
    delay_.setInterval(kDelayMilliseconds);
    connect(&delay_, &QTimer::timeout, this, &ReadyChecker::start);
    connect(&document_, &Document::changed, this, &ReadyChecker::onChanged);
    plan_ = planOfDocument();
    if (plan_.garment) {
        delay_.start();
    }
}

void ReadyChecker::setGuessesKept(bool kept) {
    if (kept != guessesKept_) {
        guessesKept_ = kept;
        delay_.start();
    }
}

void ReadyChecker::onChanged() {
    CutPlan plan = planOfDocument();
    if (plan == std::exchange(asked_, plan)) {
        return;
    }
    worker_.cancel();
    if (!document_.garment() && plan_.garment) {
        plan_ = {};
        readiness_ = {};
        emit changed();
    }
    delay_.start();
}

std::shared_ptr<const Proof> ReadyChecker::proofNow() const {
    const auto& shown = document_.proof();
    return shown && shown->plan.sewn == SewnPattern::Own && document_.isProofCurrent()
               ? shown->proof
               : nullptr;
}

CutPlan ReadyChecker::planOfDocument() const {
    const auto& [path, reference] = document_.state().reference;
    return {.garment = document_.garment(),
            .results = document_.results(),
            .options = document_.options(),
            .lines = document_.state().lines,
            .fabric = document_.fabric(),
            .materials = document_.state().materials,
            .pattern = document_.derived().pattern,
            .settings = document_.settings(),
            .labels = document_.state().labels,
            .rules = clothRules(document_.state().markers.all()),
            .proof = proofNow(),
            .referenceName = pathText(path.filename()),
            .referenceNotes = reference ? reference->notes : std::vector<Wording>{},
            .guessesKept = guessesKept_};
}

void ReadyChecker::start() {
    if (worker_.isBusy()) {
        return;  // it has been cancelled, and then this comes again
    }
    CutPlan plan = planOfDocument();
    if (plan == plan_) {
        return;
    }
    worker_.start([plan](Progress& progress) { return readyToCut(plan, progress); },
                  [this, plan](Attempt<Readiness> made, const Progress& progress) {
                      take(plan, std::move(made), progress.isCancelled());
                  });
}

void ReadyChecker::take(CutPlan plan, Attempt<Readiness> made, bool isCancelled) {
    if (made.answer && !isCancelled) {
        plan_ = std::move(plan);
        readiness_ = *std::move(made.answer);
        emit changed();
    }
    // Out of memory: what was known before is shown on, and the next change asks again. Else what
    // has changed while this ran may have been asked for in vain.
    const bool isLost = !made.answer && !isCancelled;
    if (!isLost && !worker_.isBusy() && !(planOfDocument() == plan_)) {
        delay_.start();
    }
}

}  // namespace toile::app
