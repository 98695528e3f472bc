// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of how files are read, divided and cut: how they follow one another, and become steps.
#include <utility>

#include "app/actions/workspace.h"
#include "app/jobs/garment_jobs.h"
#include "app/text/error_text.h"

namespace toile {
namespace {

/// True where the files have to be read or divided again: cuts and ease alone do not need that.
bool needsReading(const LoadOptions& before, LoadOptions after) {
    after.seams = before.seams;
    after.seamSettings = before.seamSettings;
    after.autoCut = before.autoCut;
    return !(before == after);
}

}  // namespace

LoadOptions Workspace::loading() const {
    if (opening_.files()) {
        return opening_.files()->loading;
    }
    LoadOptions loading = document_.loading();
    for (const Wish& wish : wishes_) {
        wish.change(loading);
    }
    return loading;
}

void Workspace::reload() {
    wish({tr("Reload"), [](LoadOptions&) {}, true});
}

void Workspace::setLoading(LoadOptions loading) {
    wish({tr("Reading"),
          [loading = std::move(loading)](LoadOptions& options) { options = loading; }, true});
}

template <class Value>
void Workspace::wishFor(const QString& text, Value LoadOptions::*field, const Value& value) {
    wish({text, [field, value](LoadOptions& options) { options.*field = value; }, false});
}

void Workspace::setUnit(std::optional<LengthUnit> unit) {
    wishFor(tr("Unit"), &LoadOptions::unit, unit);
}

void Workspace::setUpAxis(std::optional<UpAxis> up) {
    wishFor(tr("Up axis"), &LoadOptions::up, up);
}

void Workspace::setSplit(SplitMode split) {
    wishFor(tr("Division"), &LoadOptions::split, split);
}

void Workspace::setAutoCut(bool on) {
    wishFor(tr("Automatic cuts"), &LoadOptions::autoCut, on);
}

void Workspace::setWeld(bool on) {
    wishFor(tr("Welding"), &LoadOptions::weld, on);
}

void Workspace::wish(Wish wish) {
    // What the garment that comes will be like is not known before it is here.
    const bool waits = opening_.isActive() && !opening_.files();
    if (!wish.reads && !waits) {
        const LoadOptions before = loading();
        LoadOptions after = before;
        wish.change(after);
        if (after == before) {
            return;  // it is so, or is going to be
        }
    }
    if (opening_.files()) {
        wish.change(opening_.files()->loading);
        startOpening();
        return;
    }
    if (!document_.garment() && !waits) {
        LoadOptions loading = document_.loading();
        wish.change(loading);
        document_.setLoading(std::move(loading));
        return;
    }
    wishes_.push_back(std::move(wish));
    emit loadingChanged();
    if (wishes_.size() == 1 && !waits) {
        grantWish();
    }
}

void Workspace::grantWish() {
    LoadOptions loading = document_.loading();
    wishes_.front().change(loading);
    if (!wishes_.front().reads && loading == document_.loading()) {
        jobs_.drop(change_);
        wishes_.pop_front();  // a step of the history has done it meanwhile
        emit loadingChanged();
        follow();
        return;
    }
    const auto done = [this, loading](MadeGarment made) { onGranted(loading, std::move(made)); };
    if (wishes_.front().reads || needsReading(document_.loading(), loading)) {
        begin(importJob(openPaths(), loading, document_.state(), done));
    } else {
        begin(cutJob(document_.state(), loading, done));
    }
}

void Workspace::onGranted(const LoadOptions& loading, MadeGarment made) {
    const Wish granted = std::move(wishes_.front());
    wishes_.pop_front();
    if (const auto objection =
            granted.objection ? granted.objection(*made.garment) : std::nullopt) {
        emit loadingChanged();
        emit refused(errorText(*objection));
        follow();
        return;
    }
    DocumentState next = document_.state();
    next.loading = resolveNames(loading, *made.garment);
    next.settings = carriedSettings(made.carried, next.settings);
    if (!next.results.empty()) {  // else nothing is flat yet, and all is to be
        next.results = carriedResults(next.results, *made.garment);
    }
    next.garment = std::move(made.garment);
    next.scene = std::move(made.scene);
    document_.edit(granted.text, std::move(next));
    emit loadingChanged();  // the wish waits no more
    follow();
}

}  // namespace toile
