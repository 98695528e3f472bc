// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>

#include "app/document/document_state.h"
#include "app/jobs/garment_jobs.h"
#include "app/jobs/job_runner.h"

namespace toile {
class GarmentFlattener;
}  // namespace toile

namespace toile::app {

class Document;
class DocumentChange;

/// Derives the results for the document's state, in one job, whenever part of them is missing. The
/// garment is always made; whether it is flattened depends on the last request:
///
///     as usual   flattened if that is automatic, or if nothing is flat yet
///     wanted     opened or requested: flattened whatever is edited meanwhile, until it is flat
///     declined   cancelled or failed: not flattened until something else is requested
///
/// Pieces that are left out are removed at once in any case. Warm results are shown at once, and
/// cold ones replace them when nothing else is to be done. If a garment cannot be made, the steps
/// that asked for it are undone. GUI thread only.
class Recompute : public QObject {
    Q_OBJECT

public:
    /// Why a new garment is refused, if it is; changes the state to the one that replaces it.
    using Objection = std::function<std::optional<Error>(const Garment&, DocumentState&)>;

    /// Both must outlive this. All jobs must have ended before this is destroyed.
    Recompute(Document& document, JobRunner& jobs);
    ~Recompute() override;

    void setObjection(Objection objection) { objection_ = std::move(objection); }
    bool isAutomatic() const { return automatic_; }
    /// True if edits are flattened automatically, as by default.
    void setAutomatic(bool on);
    /// Suspends flattening; call `catchUp` afterwards.
    void setHeld(bool held) { isHeld_ = held; }
    /// Requests flattening, of flat pieces too, and ends its suspension.
    void want() {
        flattening_ = Flattening::Wanted;
        isHeld_ = false;
    }
    /// Resets a declined request: the user has undone a step.
    void retry();
    /// Starts the work that is due, unless it is running, and stops other work. Do not call it
    /// while other jobs change the state: it replaces them.
    void catchUp();
    /// Other jobs replace the running one.
    void yield() { ticket_ = 0; }
    /// Call it when the user has cancelled a job, or it has failed.
    void onStopped(bool failed);

signals:
    /// The request is impossible, and why; it has been undone.
    void refused(const toile::Error& why);

private:
    enum class Flattening { AsUsual, Wanted, Declined };

    /// The task of a job: if that changes, another job is needed.
    struct Order {
        std::uint64_t revision = 0;
        RecomputeOrder extent{};
        bool draw = false;

        bool operator==(const Order&) const = default;
    };

    void onOpened();
    void onChanged(const DocumentChange& what);
    bool isDue(const Order& order) const;
    Order due() const;
    void take(Derivation made);

    Document& document_;
    JobRunner& jobs_;
    std::shared_ptr<GarmentFlattener> flattener_;
    Objection objection_;
    bool automatic_ = true;
    Flattening flattening_ = Flattening::AsUsual;
    bool isHeld_ = false;
    bool noScene_ = false;                     ///< making a scene has failed, and would fail again
    std::optional<std::uint64_t> notSettled_;  ///< revision that is not settled
    JobRunner::Ticket ticket_ = 0;
    Order order_;
};

}  // namespace toile::app
