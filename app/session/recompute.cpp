// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/recompute.h"

#include <utility>

#include "app/document/disposal.h"
#include "app/document/document.h"
#include "app/jobs/derivation.h"
#include "core/toile/garment_flattener.h"

namespace toile::app {
namespace {

std::shared_ptr<GarmentFlattener> newFlattener() {
    return sharedForDisposal(std::make_unique<GarmentFlattener>());
}

}  // namespace

Recompute::Recompute(Document& document, JobRunner& jobs)
    : document_(document), jobs_(jobs), flattener_(newFlattener()) {
    connect(&document_, &Document::opened, this, &Recompute::onOpened);
    connect(&document_, &Document::changed, this, &Recompute::onChanged);
}

Recompute::~Recompute() = default;

void Recompute::setAutomatic(bool on) {
    automatic_ = on;
    if (on && flattening_ == Flattening::Declined) {
        flattening_ = Flattening::AsUsual;
    } else if (!on && flattening_ == Flattening::AsUsual && order_.extent.flatten &&
               jobs_.isUnderWay(ticket_)) {
        flattening_ = Flattening::Wanted;  // continue what has begun
    }
}

void Recompute::retry() {
    if (flattening_ == Flattening::Declined) {
        flattening_ = Flattening::AsUsual;
    }
}

void Recompute::onOpened() {
    // The garment that was open before must not influence the results of another.
    flattener_ = newFlattener();
    noScene_ = false;
    flattening_ = document_.isFlattened() ? Flattening::AsUsual : Flattening::Wanted;
}

void Recompute::onChanged(const DocumentChange& what) {
    if (what.touches(&Derived::garment, &Derived::results, &Derived::scene)) {
        noScene_ = false;
    }
    const bool isOverruled = automatic_ && flattening_ == Flattening::Declined &&
                             document_.revision() != order_.revision;
    if (document_.isFlattened() || isOverruled) {
        flattening_ = Flattening::AsUsual;  // derived, or brought back by undo
    }
}

Recompute::Order Recompute::due() const {
    Order order{document_.revision()};
    if (document_.garment()) {
        const bool usual = !document_.isFlattened() &&
                           (automatic_ || document_.results().empty() || document_.wasFlattened());
        order.extent.flatten = !isHeld_ && (flattening_ == Flattening::Wanted ||
                                            (flattening_ == Flattening::AsUsual && usual));
        order.extent.leaveOut = !order.extent.flatten && document_.isCurrent() && !noScene_ &&
                                isLeftOutOtherwise(document_.derived(), document_.state());
        order.extent.settle = !order.extent.flatten && document_.isCurrent() &&
                              isWarm(document_.derived()) && notSettled_ != order.revision;
        order.draw = !document_.scene() && !noScene_;
    }
    return order;
}

bool Recompute::isDue(const Order& order) const {
    return document_.garment() && (!document_.isCurrent() || order.extent.flatten ||
                                   order.extent.leaveOut || order.extent.settle || order.draw);
}

void Recompute::catchUp() {
    const Order wanted = due();
    if (jobs_.isUnderWay(ticket_)) {
        if (wanted == order_) {
            return;
        }
        jobs_.drop(ticket_);
    }
    order_ = wanted;
    ticket_ = 0;
    if (!isDue(order_)) {
        return;
    }
    // A dropped job may still call this.
    const auto isWanted = std::make_shared<JobRunner::Ticket>(0);
    const auto onGarment = [this, isWanted](Derivation made) {
        QMetaObject::invokeMethod(
            this,
            [this, isWanted, made = std::move(made)] {
                if (*isWanted == ticket_ && jobs_.isUnderWay(ticket_)) {
                    take(made);
                }
            },
            Qt::QueuedConnection);
    };
    auto job = recomputeJob(document_, order_.extent, flattener_, onGarment,
                            [this, of = order_.revision](Derivation made) {
                                if (of == document_.revision()) {  // else it is stale
                                    take(std::move(made));
                                }
                            });
    const bool isUrgent = !document_.isCurrent() || order_.extent.flatten;
    ticket_ = isUrgent ? jobs_.replace(std::move(job)) : jobs_.start(std::move(job));
    *isWanted = ticket_;
}

void Recompute::take(Derivation made) {
    if (made.hasOtherGarment && objection_) {
        DocumentState rest = document_.state();
        if (const auto error = objection_(*made.derived.garment, rest)) {
            jobs_.drop(std::exchange(ticket_, 0));
            document_.takeBack(std::move(rest));
            emit refused(*error);
            return;
        }
    }
    if (!made.hasOtherGarment) {  // the ease of its seams may have changed meanwhile
        made.derived.inputs = document_.derived().inputs;
        made.derived.garment = document_.garment();
    }
    if (order_.extent.flatten && !made.motions.empty()) {
        // Flattening again would give no more results.
        flattening_ = app::isFlattened(made.derived, document_.state()) ? Flattening::AsUsual
                                                                        : Flattening::Declined;
    }
    if (order_.extent.settle && isWarm(made.derived)) {
        notSettled_ = order_.revision;  // for example of older lines: it would be warm again
    }
    SettingsById settings = settingsAfter(made, document_.state(), document_.settings());
    document_.show(std::move(made.derived), std::move(settings));
}

void Recompute::onStopped(bool failed) {
    if (ticket_ == 0 || jobs_.isUnderWay(ticket_)) {
        return;
    }
    ticket_ = 0;
    if (!document_.isCurrent()) {
        DocumentState rest = document_.state();
        rest.inputs = document_.derived().inputs;
        document_.takeBack(std::move(rest));
    } else if (order_.extent.flatten) {
        flattening_ = Flattening::Declined;
    } else if (order_.extent.settle) {
        notSettled_ = document_.revision();
    } else {
        noScene_ = failed;  // otherwise make it again: something has to be shown
    }
    catchUp();
}

}  // namespace toile::app
