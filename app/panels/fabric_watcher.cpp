// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/fabric_watcher.h"

#include <utility>

#include <QtConcurrent/QtConcurrentRun>

#include "app/document/document.h"

namespace toile {

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
    connect(&watcher_, &QFutureWatcherBase::finished, this, &FabricWatcher::onFinished);
    start(questionOf(document_));
}

FabricWatcher::~FabricWatcher() {
    watcher_.waitForFinished();
}

void FabricWatcher::onChanged(DocumentChanges what) {
    if (!(what & (DocumentChange::Garment | DocumentChange::Results | DocumentChange::View |
                  DocumentChange::Fabric | DocumentChange::Settings))) {
        return;
    }
    if (isRunning_) {
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
    isRunning_ = true;
    watcher_.setFuture(QtConcurrent::run(
        [work = work_, question = std::move(question)]() -> Attempt<std::optional<FabricFit>> {
            return attempt([&] { return work(question); });
        }));
}

void FabricWatcher::show(const std::optional<FabricFit>& fit, const QString& problem) {
    if (fit != fit_ || problem != problem_) {
        fit_ = fit;
        problem_ = problem;
        emit changed();
    }
}

void FabricWatcher::onFinished() {
    isRunning_ = false;
    FabricQuestion question = questionOf(document_);
    const bool isStale = !isSameQuestion(question, asked_);
    // Of an earlier fabric or grain it is shown all the same, so that a long drag shows something.
    if (question.scene == asked_.scene) {
        const auto made = watcher_.result();
        made.answer ? show(*made.answer) : show(std::nullopt, faultText(made.fault));
    }
    if (isStale) {
        start(std::move(question));
    }
}

}  // namespace toile
