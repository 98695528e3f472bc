// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/overlay_watcher.h"

#include <utility>

#include "app/document/document.h"
#include "app/render/scene.h"
#include "app/text/error_text.h"
#include "app/views/sewn_run.h"

namespace toile::app {

namespace {

/// Up to this many triangles, the figures take a millisecond or two.
constexpr std::size_t kSmall = 30000;

bool isSmall(const OverlayQuestion& question) {
    return !question.scene || !isMeasured(question.overlay) ||
           question.scene->faces.size() < kSmall;
}

}  // namespace

OverlayWatcher::OverlayWatcher(Document& document, QObject* parent, const Work& work)
    : QObject(parent),
      document_(document),
      follower_(
          work,
          [this](Attempt<OverlayFigures> made, const auto&, bool isLast) {
              if (!made.answer) {
                  emit failed(faultText(made.fault));
              }
              OverlayFigures found = made.answer ? std::move(*made.answer) : figures_;
              // Show older answers for the same overlay too, so that a long drag also gets updates.
              if (isLast || isOfTheSame(found)) {
                  show(std::move(found));
              }
          },
          isSmall) {
    connect(&document_, &Document::changed, this, &OverlayWatcher::ask);
    ask();
}

void OverlayWatcher::ask() {
    const OverlayQuestion question{
        document_.scene(), placesOf(document_.settings(), {}, document_.state().materials),
        document_.fabric(), document_.view().overlay,
        isOfProof(document_.view().overlay) ? sewnOf(document_) : nullptr};
    follower_.ask(question);
    if (follower_.isBusy()) {
        // Overlay and scale need no computation.
        if (OverlayFigures first = firstFigures(question); !isOfTheSame(first)) {
            show(std::move(first));
        }
    }
}

void OverlayWatcher::show(OverlayFigures figures) {
    figures_ = std::move(figures);
    emit changed();
}

bool OverlayWatcher::isOfTheSame(const OverlayFigures& other) const {
    return clothOf(other.scene) == clothOf(figures_.scene) && other.overlay == figures_.overlay &&
           other.sewn == figures_.sewn && other.scale == figures_.scale;
}

}  // namespace toile::app
