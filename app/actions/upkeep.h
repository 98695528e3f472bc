// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_change.h"
#include "app/document/document_state.h"
#include "app/jobs/job_runner.h"

namespace toile {

class Document;

/// Keeps there what follows from the present state: flat pieces, and a scene to look at. Which of
/// the two is due is a matter of the state and of what was said last:
///
///     as usual   flattened where that happens by itself, or where nothing is flat yet (what was
///                opened, what was let go)
///     wanted     opened or asked for: flattened whatever is edited meanwhile, until it is flat
///     declined   cancelled or failed: not flattened until pieces or options are others, a step
///                leads to what was flat and let go, or it is asked for
///
/// A scene is due wherever there is none. GUI thread only.
class Upkeep {
public:
    /// Both must outlive this.
    Upkeep(Document& document, JobRunner& jobs) : document_(document), jobs_(jobs) {}

    bool isAutomatic() const { return automatic_; }
    /// Whether what was edited is flattened by itself; at first it is.
    void setAutomatic(bool on);
    /// Flattening is wanted, of what is flat already too.
    void want() { flattening_ = Flattening::Wanted; }
    /// To be called with every change of the document.
    void note(DocumentChanges what);
    /// To be called when a step has led to a state that was flat and was let go: it is to be again.
    void noteStepToLetGo();
    /// Has begun what is due, and nothing else, unless it is on its way. Not while other jobs are
    /// to change the state: it takes their place.
    void catchUp();
    /// Other jobs take the place of what is on its way.
    void giveWay() { ticket_ = 0; }
    /// To be called when a job was cancelled by the person.
    void onCancelled();
    /// To be called when a job has failed.
    void onFailed();

private:
    enum class Flattening { AsUsual, Wanted, Declined };
    enum class Work { Nothing, Flattening, Scene };

    /// What a job is of: where that is another, so is the job.
    struct Order {
        Work work = Work::Nothing;
        std::uint64_t revision = 0;
        std::shared_ptr<const Garment> garment{};  ///< of a scene; flattening does not see the ease
        PieceResults results{};

        bool operator==(const Order&) const = default;
    };

    Work due() const;
    Order order(Work work) const;
    /// Whether there was a job of this, and is no more.
    bool isOver() const { return ticket_ != 0 && !jobs_.isUnderWay(ticket_); }

    Document& document_;
    JobRunner& jobs_;
    bool automatic_ = true;
    Flattening flattening_ = Flattening::AsUsual;
    bool noScene_ = false;  ///< making one has failed, and would again
    JobRunner::Ticket ticket_ = 0;
    Order order_;
};

}  // namespace toile
