// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/upkeep.h"

#include <utility>

#include "app/document/document.h"
#include "app/jobs/garment_jobs.h"

namespace toile {

void Upkeep::setAutomatic(bool on) {
    automatic_ = on;
    if (on && flattening_ == Flattening::Declined) {
        flattening_ = Flattening::AsUsual;
    } else if (!on && flattening_ == Flattening::AsUsual && order_.work == Work::Flattening &&
               jobs_.isUnderWay(ticket_)) {
        flattening_ = Flattening::Wanted;  // what has begun goes on
    }
}

void Upkeep::note(DocumentChanges what) {
    const DocumentState& state = document_.state();
    if (what & (DocumentChange::Garment | DocumentChange::Seams | DocumentChange::Results)) {
        noScene_ = false;
    }
    if (what.testFlag(DocumentChange::Opened)) {
        flattening_ = isFlattened(state) ? Flattening::AsUsual : Flattening::Wanted;
        return;
    }
    const bool isAnother = what & (DocumentChange::Garment | DocumentChange::Options);
    if (!isAnother && !what.testFlag(DocumentChange::Results)) {
        return;
    }
    const bool isOverruled = isAnother && automatic_ && flattening_ == Flattening::Declined;
    if (isFlattened(state) || isOverruled) {
        flattening_ = Flattening::AsUsual;  // it has come, or a step has brought it back
    } else if (!isAnother && isOver() && order_.work == Work::Flattening) {
        flattening_ = Flattening::Declined;  // more than what has come there will not be
    }
}

void Upkeep::noteStepToLetGo() {
    if (flattening_ == Flattening::Declined) {
        flattening_ = Flattening::AsUsual;
    }
}

Upkeep::Work Upkeep::due() const {
    const DocumentState& state = document_.state();
    if (!state.garment) {
        return Work::Nothing;
    }
    const bool usual = !isFlattened(state) && (automatic_ || state.results.empty());
    if (flattening_ == Flattening::Wanted || (flattening_ == Flattening::AsUsual && usual)) {
        return Work::Flattening;
    }
    return state.scene || noScene_ ? Work::Nothing : Work::Scene;
}

Upkeep::Order Upkeep::order(Work work) const {
    return {work, document_.revision(), work == Work::Scene ? document_.garment() : nullptr,
            document_.results()};
}

void Upkeep::catchUp() {
    Order wanted = order(due());
    if (jobs_.isUnderWay(ticket_)) {
        if (wanted == order_) {
            return;
        }
        jobs_.drop(ticket_);
    }
    order_ = std::move(wanted);
    switch (order_.work) {
        case Work::Nothing:
            ticket_ = 0;
            break;
        case Work::Flattening:
            ticket_ = jobs_.replace(flattenJob(document_));
            break;
        case Work::Scene:
            ticket_ = jobs_.start(sceneJob(document_));
            break;
    }
}

void Upkeep::onCancelled() {
    // A scene comes again: nobody wants to see nothing.
    if (isOver() && order_.work == Work::Flattening) {
        flattening_ = Flattening::Declined;
    }
    catchUp();
}

void Upkeep::onFailed() {
    if (isOver()) {
        if (order_.work == Work::Flattening) {
            flattening_ = Flattening::Declined;
        }
        noScene_ = order_.work == Work::Scene;
    }
    catchUp();
}

}  // namespace toile
