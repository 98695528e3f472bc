// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/ready_checker.h"

#include <utility>

#include "app/document/document.h"
#include "app/document/shown_proof.h"
#include "core/base/file.h"

namespace toile::app {

namespace {

/// Changes closer together than this are answered once.
constexpr int kDelayMilliseconds = 60;

}  // namespace

ReadyChecker::ReadyChecker(Document& document, QObject* parent)
    : QObject(parent),
      document_(document),
      follower_(
          readyToCut,
          [this](Attempt<Readiness> made, const CutPlan& plan, bool) {
              if (made.answer) {  // otherwise memory is short: keep the earlier findings
                  plan_ = plan;
                  readiness_ = *std::move(made.answer);
                  emit changed();
              }
          },
          {}, kDelayMilliseconds) {
    connect(&document_, &Document::changed, this, &ReadyChecker::ask);
    plan_ = planOfDocument();
    if (plan_.garment) {
        ask();
    }
}

void ReadyChecker::setGuessesKept(bool kept) {
    guessesKept_ = kept;
    ask();
}

void ReadyChecker::ask() {
    follower_.ask(planOfDocument());
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

}  // namespace toile::app
