// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/base/worker.h"
#include "app/document/document_change.h"
#include "app/render/overlay_values.h"

namespace toile::app {

class Document;

/// Keeps what of the garment goes beyond its fabric as the document is. That of a small garment at
/// once; that of a large one is worked out on another thread and comes a moment later.
class FabricWatcher : public QObject {
    Q_OBJECT

public:
    using Work = std::function<std::optional<FabricFit>(const FabricQuestion&)>;

    explicit FabricWatcher(Document& document, QObject* parent = nullptr, Work work = fabricFit);

    /// None where nothing is flat; of an earlier fabric or grain while `isUpToDate` is false.
    const std::optional<FabricFit>& fit() const { return fit_; }
    /// Why the fit could not be worked out; empty where it could.
    const QString& problem() const { return problem_; }
    bool isUpToDate() const { return !worker_.isBusy(); }

signals:
    void changed();

private:
    void onChanged(DocumentChanges what);
    void start(FabricQuestion question);
    void show(const std::optional<FabricFit>& fit, const QString& problem = {});
    void take(const Attempt<std::optional<FabricFit>>& made);

    Document& document_;
    Work work_;
    FabricQuestion asked_;  ///< last
    std::optional<FabricFit> fit_;
    QString problem_;
    Worker<std::optional<FabricFit>> worker_;
};

}  // namespace toile::app
