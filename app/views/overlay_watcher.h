// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "app/base/worker.h"
#include "app/render/overlay_figures.h"

namespace toile::app {

class Document;

/// Keeps the overlay's figures up to date. Those of a small garment are computed at once. Those of
/// a large one are computed on another thread, latest question first, and arrive later.
class OverlayWatcher : public QObject {
    Q_OBJECT

public:
    using Work = std::function<OverlayFigures(const OverlayQuestion&)>;

    explicit OverlayWatcher(Document& document, QObject* parent = nullptr,
                            const Work& work = overlayFigures);

    /// Overlay and scale always match the document. While `isUpToDate` is false, histogram and
    /// spots may be missing or belong to an earlier grain.
    const OverlayFigures& figures() const { return figures_; }
    bool isUpToDate() const { return !follower_.isBusy(); }

signals:
    void changed();
    /// The figures could not be computed: only overlay and scale are available.
    void failed(const QString& sentence);

private:
    void ask();
    void show(OverlayFigures figures);
    /// Whether only the grain differs from the figures shown.
    bool isOfTheSame(const OverlayFigures& other) const;

    Document& document_;
    OverlayFigures figures_;
    Follower<OverlayQuestion, OverlayFigures> follower_;
};

}  // namespace toile::app
