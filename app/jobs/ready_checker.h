// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/base/worker.h"
#include "core/check/ready_to_cut.h"

namespace toile::app {

class Document;

/// Keeps the findings of "ready to cut?" as the document is: looked through anew on another thread
/// whenever garment, results, options, fabric, settings, ease, the proof, the reference pattern or
/// the settings of markers change. Changes that follow each other closely, as those of a drag, are
/// answered once; an outdated search is cancelled. GUI thread only.
class ReadyChecker : public QObject {
    Q_OBJECT

public:
    explicit ReadyChecker(Document& document, QObject* parent = nullptr);

    /// Of `plan`; empty where nothing is open.
    const Readiness& readiness() const { return readiness_; }
    /// What the findings are about: their indices are of its garment, which may be another than the
    /// document's for a moment.
    const CutPlan& plan() const { return plan_; }
    /// False while an answer is on its way.
    bool isUpToDate() const { return !follower_.isBusy(); }
    /// Whether a person has said that unit and up axis were guessed right.
    void setGuessesKept(bool kept);

signals:
    /// `readiness` is another.
    void changed();

private:
    void ask();
    CutPlan planOfDocument() const;
    /// Of the document's own pattern as it is now; null: there is none.
    std::shared_ptr<const Proof> proofNow() const;

    Document& document_;
    CutPlan plan_;
    Readiness readiness_;
    bool guessesKept_ = false;
    Follower<CutPlan, Readiness> follower_;
};

}  // namespace toile::app
