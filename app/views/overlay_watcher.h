// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "app/base/worker.h"
#include "app/document/document_change.h"
#include "app/render/overlay_figures.h"

namespace toile::app {

class Document;

/// Keeps the overlay's figures as the document is. Those of a small garment at once; those of a
/// large one are worked out on another thread, the last wish first, and come some time later.
class OverlayWatcher : public QObject {
    Q_OBJECT

public:
    using Work = std::function<OverlayFigures(const OverlayQuestion&)>;

    explicit OverlayWatcher(Document& document, QObject* parent = nullptr,
                            Work work = overlayFigures);

    /// Overlay and scale are the document's; histogram and spots may be of an earlier grain, or not
    /// there yet, while `isUpToDate` is false.
    const OverlayFigures& figures() const { return figures_; }
    bool isUpToDate() const { return !worker_.isBusy(); }

signals:
    void changed();
    /// The figures could not be worked out: there is overlay and scale alone.
    void failed(const QString& sentence);

private:
    void onChanged(DocumentChanges what);
    void start(OverlayQuestion question);
    /// Overlay and scale at once, where they are others.
    void showFirst(const OverlayQuestion& question);
    void take(Attempt<OverlayFigures> made);

    Document& document_;
    Work work_;
    OverlayQuestion asked_;  ///< last
    OverlayFigures figures_;
    Worker<OverlayFigures> worker_;
    bool isStale_ = false;
};

}  // namespace toile::app
