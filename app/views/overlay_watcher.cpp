// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/overlay_watcher.h"

#include <utility>

#include <QtConcurrent/QtConcurrentRun>

#include "app/document/document.h"
#include "app/render/scene.h"

namespace toile {

namespace {

/// Triangles whose figures take a millisecond or two.
constexpr std::size_t kSmall = 30000;

OverlayQuestion questionOf(const Document& document) {
    const ViewState& view = document.view();
    return {document.scene(), placesOf(document.settings()), document.fabric(), view.overlay};
}

}  // namespace

OverlayWatcher::OverlayWatcher(Document& document, QObject* parent, Work work)
    : QObject(parent), document_(document), work_(std::move(work)) {
    connect(&document_, &Document::changed, this, &OverlayWatcher::onChanged);
    connect(&watcher_, &QFutureWatcherBase::finished, this, &OverlayWatcher::onFinished);
    start(questionOf(document_));
}

OverlayWatcher::~OverlayWatcher() {
    watcher_.waitForFinished();
}

void OverlayWatcher::onChanged(DocumentChanges what) {
    if (!(what & (DocumentChange::Garment | DocumentChange::Results | DocumentChange::View |
                  DocumentChange::Fabric | DocumentChange::Settings))) {
        return;
    }
    OverlayQuestion question = questionOf(document_);
    if (isSameQuestion(question, asked_)) {
        // Back at what is being worked out: its answer counts again.
        if (std::exchange(isStale_, false)) {
            showFirst(question);
        }
        return;
    }
    if (!isRunning_) {
        start(std::move(question));
        return;
    }
    isStale_ = true;
    showFirst(question);
}

void OverlayWatcher::start(OverlayQuestion question) {
    asked_ = question;
    if (!question.scene || !isMeasured(question.overlay) || question.scene->faces.size() < kSmall) {
        figures_ = overlayFigures(question);
        emit changed();
        return;
    }
    showFirst(question);
    isRunning_ = true;
    watcher_.setFuture(QtConcurrent::run(
        [work = work_, question = std::move(question)]() -> Attempt<OverlayFigures> {
            return attempt([&] { return work(question); });
        }));
}

void OverlayWatcher::showFirst(const OverlayQuestion& question) {
    OverlayFigures first = firstFigures(question);
    const bool onlyGrainChanges = first.scene == figures_.scene &&
                                  first.overlay == figures_.overlay &&
                                  first.scale == figures_.scale;
    if (!onlyGrainChanges) {
        figures_ = std::move(first);
        emit changed();
    }
}

void OverlayWatcher::onFinished() {
    isRunning_ = false;
    Attempt<OverlayFigures> made = watcher_.result();
    const bool isStale = std::exchange(isStale_, false);
    if (!made.answer) {
        emit failed(faultText(made.fault));
    }
    OverlayFigures found = made.answer ? std::move(*made.answer) : figures_;
    if (!isStale) {
        figures_ = std::move(found);
        emit changed();
        return;
    }
    // Of what was asked before: shown only where nothing but the grain has been turned since, so
    // that a long drag does not starve.
    if (found.scene == figures_.scene && found.overlay == figures_.overlay &&
        found.scale == figures_.scale) {
        figures_ = std::move(found);
        emit changed();
    }
    start(questionOf(document_));
}

}  // namespace toile
