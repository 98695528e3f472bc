// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "app/base/worker.h"
#include "app/render/overlay_figures.h"

namespace toile::app {

class Document;

/// Keeps the overlay's figures as the document is. Those of a small garment at once; those of a
/// large one are worked out on another thread, the last question first, and come some time later.
class OverlayWatcher : public QObject {
    Q_OBJECT

public:
    using Work = std::function<OverlayFigures(const OverlayQuestion&)>;

    explicit OverlayWatcher(Document& document, QObject* parent = nullptr,
                            const Work& work = overlayFigures);

    /// Overlay and scale are the document's; histogram and spots may be of an earlier grain, or not
    /// there yet, while `isUpToDate` is false.
    const OverlayFigures& figures() const { return figures_; }
    bool isUpToDate() const { return !follower_.isBusy(); }

signals:
    void changed();
    /// The figures could not be worked out: there is overlay and scale alone.
    void failed(const QString& sentence);

private:
    void ask();
    void show(OverlayFigures figures);
    /// Nothing but the grain has been turned since those that are shown.
    bool isOfTheSame(const OverlayFigures& other) const;

    Document& document_;
    OverlayFigures figures_;
    Follower<OverlayQuestion, OverlayFigures> follower_;
};

}  // namespace toile::app
