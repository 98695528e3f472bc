// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "app/document/shown_proof.h"
#include "app/jobs/job_runner.h"
#include "app/jobs/proof_job.h"

namespace toile::app {

class Document;
class DocumentChange;

/// Proves the document's pattern by sewing it back together with the settings of the state. Works
/// beside all other jobs, and shows the cloth meanwhile. A proof stays until the next one, and is
/// out of date when the pattern is edited (`Document::isProofCurrent`). GUI thread only.
class PatternProof : public QObject {
    Q_OBJECT

public:
    /// How often the cloth is shown while it is sewn, milliseconds.
    static constexpr int kPause = 100;

    /// Both must outlive this. @param runner  used for nothing else
    PatternProof(Document& document, JobRunner& runner);
    ~PatternProof() override;

    /// The settings that apply now: `proofPlanOf`.
    ProofPlan plan() const;
    /// True if everything is flattened as the state asks, and something can be sewn.
    bool canProve() const;
    bool isRunning() const { return runner_.isBusy(); }
    const JobRunner& runner() const { return runner_; }
    /// Sews the pattern as it is now; starts again if it is being sewn. Does nothing if it cannot
    /// be sewn.
    void begin();
    /// Shows the earlier proof again.
    void cancel() { runner_.cancel(); }
    /// Asks the window for a proof.
    void want() { emit wanted(); }

signals:
    /// The settings, or whether it is running.
    void changed();
    /// The document shows a new proof.
    void proved();
    void wanted();

private:
    void onChanged(const DocumentChange& what);
    /// Shows the present state of the cloth.
    void fetch();
    void onIdle();
    /// Adapts the proof to the present scene, if that has changed but the cloth has not, as after
    /// edits of notches or allowances.
    void fit();

    Document& document_;
    JobRunner& runner_;
    std::shared_ptr<Mailbox<ShownProof>> mailbox_;
    QTimer poll_;
};

}  // namespace toile::app
