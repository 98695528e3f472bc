// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/fabric_watcher.h"

#include <utility>

#include "app/document/document.h"
#include "app/text/error_text.h"

namespace toile::app {

namespace {

/// Triangles whose figures take a millisecond or two, in three directions.
constexpr std::size_t kSmall = 10000;

FabricQuestion questionOf(const Document& document) {
    return {document.scene(), placesOf(document.settings()), document.fabric()};
}

}  // namespace

FabricWatcher::FabricWatcher(Document& document, QObject* parent, Work work)
    : QObject(parent), document_(document), work_(std::move(work)) {
    connect(&document_, &Document::changed, this, &FabricWatcher::onChanged);
    start(questionOf(document_));
}

void FabricWatcher::onChanged(DocumentChanges what) {
    if (!(what & (DocumentChange::Garment | DocumentChange::Results | DocumentChange::View |
                  DocumentChange::Fabric | DocumentChange::Settings))) {
        return;
    }
    if (worker_.isBusy()) {
        if (!document_.scene()) {
            show(std::nullopt);  // nothing of a garment that is gone
        }
        return;  // asked again when that is done
    }
    FabricQuestion question = questionOf(document_);
    if (!isSameQuestion(question, asked_)) {
        start(std::move(question));
    }
}

void FabricWatcher::start(FabricQuestion question) {
    asked_ = question;
    if (!question.scene || question.scene->faces.size() < kSmall) {
        show(fabricFit(question));
        return;
    }
    worker_.start(
        [work = work_, question = std::move(question)](Progress&) { return work(question); },
        [this](const auto& made, const Progress&) { take(made); });
}

void FabricWatcher::show(const std::optional<FabricFit>& fit, const QString& problem) {
    if (fit != fit_ || problem != problem_) {
        fit_ = fit;
        problem_ = problem;
        emit changed();
    }
}

void FabricWatcher::take(const Attempt<std::optional<FabricFit>>& made) {
    FabricQuestion question = questionOf(document_);
    const bool isStale = !isSameQuestion(question, asked_);
    // Of an earlier fabric or grain it is shown all the same, so that a long drag shows something.
    if (question.scene == asked_.scene) {
        made.answer ? show(*made.answer) : show(std::nullopt, faultText(made.fault));
    }
    if (isStale) {
        start(std::move(question));
    }
}

}  // namespace toile::app
