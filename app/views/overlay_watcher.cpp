// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/overlay_watcher.h"

#include <utility>

#include "app/document/document.h"
#include "app/render/scene.h"
#include "app/text/error_text.h"

namespace toile::app {

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
    start(questionOf(document_));
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
    if (!worker_.isBusy()) {
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
    worker_.start(
        [work = work_, question = std::move(question)](Progress&) { return work(question); },
        [this](auto made, const Progress&) { take(std::move(made)); });
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

void OverlayWatcher::take(Attempt<OverlayFigures> made) {
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

}  // namespace toile::app
