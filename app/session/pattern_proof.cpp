// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/pattern_proof.h"

#include <algorithm>
#include <utility>

#include "app/document/document.h"
#include "app/render/sewn_cloth.h"

namespace toile::app {

PatternProof::PatternProof(Document& document, JobRunner& runner)
    : document_(document), runner_(runner) {
    poll_.setInterval(kPause);
    connect(&poll_, &QTimer::timeout, this, &PatternProof::fetch);
    connect(&runner_, &JobRunner::started, this, &PatternProof::changed);
    connect(&runner_, &JobRunner::idle, this, &PatternProof::onIdle);
    connect(&document_, &Document::opened, &runner_, &JobRunner::cancel);
    connect(&document_, &Document::changed, this, &PatternProof::onChanged);
}

PatternProof::~PatternProof() = default;

ProofPlan PatternProof::plan() const {
    return proofPlanOf(document_.state());
}

bool PatternProof::canProve() const {
    return document_.scene() && document_.isFlattened() &&
           std::ranges::any_of(document_.results(),
                               [](const auto& result) { return result->flat.has_value(); });
}

void PatternProof::begin() {
    if (!canProve()) {
        return;
    }
    mailbox_ = std::make_shared<Mailbox<ShownProof>>();
    runner_.replace(
        proofJob(document_, plan(), mailbox_, [this](std::shared_ptr<const ShownProof> found) {
            document_.showProof(std::move(found));
            document_.showSewing(nullptr);
            fit();
            emit proved();
        }));
    poll_.start();
    emit changed();
}

void PatternProof::fetch() {
    auto sewing = mailbox_->take();
    if (sewing && sewing->ground.garment == document_.garment()) {
        document_.showSewing(std::move(sewing));
    }
}

void PatternProof::onIdle() {
    poll_.stop();
    document_.showSewing(nullptr);
    emit changed();
}

void PatternProof::fit() {
    const auto& shown = document_.proof();
    if (!shown || !shown->cloth || !document_.scene() || shown->cloth->scene == document_.scene() ||
        !document_.isProofCurrent()) {
        return;
    }
    ShownProof fitting = *shown;
    fitting.cloth = sewnCloth(document_.scene(), *shown->proof, shown->plan.sewn);
    document_.showProof(std::make_shared<const ShownProof>(std::move(fitting)));
}

void PatternProof::onChanged(const DocumentChange& what) {
    fit();
    if (what.touchesContent()) {
        emit changed();
    }
}

}  // namespace toile::app
