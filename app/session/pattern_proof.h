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

/// Proves the document's pattern by sewing it back together, as its state says: does it beside all
/// other work, and shows the cloth on its way. What has been found stays until something else is,
/// and is of an earlier pattern once that has been edited (`Document::isProofCurrent`). GUI thread
/// only.
class PatternProof : public QObject {
    Q_OBJECT

public:
    /// How often the cloth on its way is shown, milliseconds.
    static constexpr int kPause = 100;

    /// Both must outlive this. @param runner  that does nothing else
    PatternProof(Document& document, JobRunner& runner);
    ~PatternProof() override;

    /// As it can be followed now: `proofPlanOf`.
    ProofPlan plan() const;
    /// Whether all is flat as the document has it, and anything can be sewn.
    bool canProve() const;
    bool isRunning() const { return runner_.isBusy(); }
    const JobRunner& runner() const { return runner_; }
    /// Sews it as it is now; starts again if it is being sewn. Does nothing if it cannot be sewn.
    void begin();
    /// What was found before is shown again.
    void cancel() { runner_.cancel(); }
    /// Somebody wants to see what only a proof can tell.
    void want() { emit wanted(); }

signals:
    /// The plan, or whether it is running.
    void changed();
    /// It is done, and the document shows it.
    void proved();
    void wanted();

private:
    void onChanged(const DocumentChange& what);
    /// What the work has reached since.
    void fetch();
    void onIdle();
    /// Lays the result on the present scene, if that has changed but the cloth has not, as after
    /// edits of notches or allowances.
    void fit();

    Document& document_;
    JobRunner& runner_;
    std::shared_ptr<ProofTray> tray_;
    QTimer poll_;
};

}  // namespace toile::app
