// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/base/worker.h"
#include "core/check/ready_to_cut.h"

namespace toile::app {

class Document;

/// Keeps the findings of "ready to cut?" up to date, on another thread. Changes that follow each
/// other closely, as in a drag, are answered once; outdated checks are cancelled. GUI thread only.
class ReadyChecker : public QObject {
    Q_OBJECT

public:
    explicit ReadyChecker(Document& document, QObject* parent = nullptr);

    /// The findings for `plan`; empty if nothing is open.
    const Readiness& readiness() const { return readiness_; }
    /// The plan that was checked: indices in findings belong to its garment, which may differ from
    /// the document's for a moment.
    const CutPlan& plan() const { return plan_; }
    /// False while a check is pending.
    bool isUpToDate() const { return !follower_.isBusy(); }
    /// Whether the user has confirmed guessed unit and up axis.
    void setGuessesKept(bool kept);

signals:
    /// `readiness` has changed.
    void changed();

private:
    void ask();
    CutPlan planOfDocument() const;
    /// The proof of the document's own pattern as it is now; null: none.
    std::shared_ptr<const Proof> proofNow() const;

    Document& document_;
    CutPlan plan_;
    Readiness readiness_;
    bool guessesKept_ = false;
    Follower<CutPlan, Readiness> follower_;
};

}  // namespace toile::app
