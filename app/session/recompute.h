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

/// Works out what follows from the document's state, in one job, whenever part of it is missing.
/// The garment always; whether it is flattened depends on the last request:
///
///     as usual   flattened where that happens by itself, or where nothing is flat yet
///     wanted     opened or asked for: flattened whatever is edited meanwhile, until it is flat
///     declined   cancelled or failed: not flattened until something else is asked for
///
/// What is left out goes at once all the same. Warm results are shown at once, and cold ones take
/// their place when nothing else is to be done. A garment that cannot be worked out takes the steps
/// back that asked for it. GUI thread only.
class Recompute : public QObject {
    Q_OBJECT

public:
    /// What is wrong with the garment that came of the state, so that it is not to be; the state is
    /// then brought to what is to be in its place.
    using Objection = std::function<std::optional<Error>(const Garment&, DocumentState&)>;

    /// Both must outlive this, and the jobs be over before it goes.
    Recompute(Document& document, JobRunner& jobs);
    ~Recompute() override;

    void setObjection(Objection objection) { objection_ = std::move(objection); }
    bool isAutomatic() const { return automatic_; }
    /// Whether what was edited is flattened by itself; at first it is.
    void setAutomatic(bool on);
    /// Nothing is flattened while it is held back; `catchUp` does it after that.
    void setHeld(bool held) { isHeld_ = held; }
    /// Flattening is wanted, of what is flat already too, and held back no longer.
    void want() {
        flattening_ = Flattening::Wanted;
        isHeld_ = false;
    }
    /// What was declined is as usual again: a step has led back.
    void retry();
    /// Has begun what is due, and nothing else, unless it is on its way. Not while other jobs are
    /// to change the state: it takes their place.
    void catchUp();
    /// Other jobs take the place of what is on its way.
    void yield() { ticket_ = 0; }
    /// To be called when a job was cancelled by the person, or has failed.
    void onStopped(bool failed);

signals:
    /// What was asked for cannot be done, and why; it has been taken back.
    void refused(const toile::Error& why);

private:
    enum class Flattening { AsUsual, Wanted, Declined };

    /// What a job is of: if that changes, another job is needed.
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
    bool noScene_ = false;                     ///< making one has failed, and would again
    std::optional<std::uint64_t> notSettled_;  ///< revision that is not to be settled
    JobRunner::Ticket ticket_ = 0;
    Order order_;
};

}  // namespace toile::app
