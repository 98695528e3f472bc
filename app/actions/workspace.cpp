// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/workspace.h"

#include <algorithm>
#include <utility>

#include "app/base/path_text.h"
#include "app/jobs/file_jobs.h"
#include "app/jobs/garment_jobs.h"

namespace toile {

Workspace::Workspace(QObject* parent) : QObject(parent) {
    connect(&document_, &Document::changed, this, &Workspace::onChanged);
    connect(&document_.history(), &QUndoStack::indexChanged, this, [this] {
        opening_.noteEdit();
        if (document_.state().letGo) {
            upkeep_.noteStepToLetGo();
            follow();
        }
    });
    // A job that makes room for another says nothing about what is asked for now.
    connect(&jobs_, &JobRunner::failed, this,
            [this](const QString&, const QString&, bool replaced) {
                if (!replaced) {
                    onFailed();
                }
            });
    connect(&jobs_, &JobRunner::cancelled, this, [this](const QString&, bool replaced) {
        if (!replaced) {
            onCancelled();
        }
    });
    connect(&writing_, &JobRunner::failed, this, [this] { afterWriting_ = {}; });
    connect(&writing_, &JobRunner::idle, this, [this] {
        if (const auto next = std::exchange(afterWriting_, {})) {
            next();
        }
    });
}

Workspace::~Workspace() {
    shutdown();
}

void Workspace::shutdown() {
    jobs_.shutdown();
    writing_.finish();
}

void Workspace::cancel() {
    if (!jobs_.isBusy()) {
        writing_.cancel();
        return;
    }
    jobs_.cancel();
    // The job says so when it has stopped; what is asked for until then is not cancelled with it.
    if (!isChanging()) {
        upkeep_.onCancelled();
    } else if (!jobs_.isUnderWay(change_)) {
        stopChanging();
    }
}

void Workspace::begin(std::unique_ptr<Job> job) {
    upkeep_.giveWay();
    change_ = jobs_.replace(std::move(job));
}

void Workspace::open(Paths files) {
    if (files.empty()) {
        return;
    }
    const bool another = opening_.isActive() && !opening_.files();
    const Paths before = opening_.files() ? opening_.files()->paths : openPaths();
    // What was wished for while another is read was about that.
    Opening::Files coming{std::move(files), another ? document_.loading() : loading()};
    if (!before.empty() && coming.paths != before) {
        coming.loading.unit.reset();
        coming.loading.up.reset();
        coming.loading.seams = {};
        coming.loading.seamSettings.clear();
        divideByWhatIsThere(coming.loading);
    }
    if (document_.garment() && coming.paths == openPaths()) {
        coming.loading.known = knownPieces(*document_.garment());  // they may have changed
    }
    wishes_.clear();
    opening_.begin(std::move(coming));
    startOpening();
}

void Workspace::startOpening() {
    emit loadingChanged();
    const Opening::Files& files = *opening_.files();
    begin(importJob(files.paths, files.loading, std::nullopt, [this](const MadeGarment& made) {
        // Another garment is not cut from the same cloth for having been opened later.
        const bool again = opening_.files()->paths == openPaths();
        arrived([this, again, loading = opening_.files()->loading, made] {
            DocumentState next;
            next.loading = resolveNames(loading, *made.garment);
            next.options = document_.options();
            if (again || !document_.garment()) {
                next.fabric = document_.fabric();
            }
            next.garment = made.garment;
            next.scene = made.scene;
            document_.open(std::move(next));
        });
    }));
}

void Workspace::openBy(std::unique_ptr<Job> reading) {
    wishes_.clear();
    opening_.begin();
    emit loadingChanged();
    begin(std::move(reading));
}

void Workspace::arrived(std::function<void()> open) {
    // What was asked for meanwhile is about what comes.
    const Opening::Next next = opening_.arrive(
        [this, open = std::move(open), wishes = std::exchange(wishes_, {})]() mutable {
            jobs_.drop(change_);  // of a wish for the garment that goes
            wishes_ = std::exchange(wishes, {});
            open();
            follow();
        });
    emit loadingChanged();
    next();
    follow();  // where it was not opened: the reading took the place of this
}

void Workspace::notOpened() {
    stopChanging();
    follow();
}

void Workspace::stopChanging() {
    if (isChanging()) {
        opening_.stop();
        wishes_.clear();
        emit loadingChanged();
    }
}

void Workspace::follow() {
    if (opening_.isActive() || jobs_.isUnderWay(change_)) {
        return;
    }
    wishes_.empty() ? upkeep_.catchUp() : grantWish();
}

void Workspace::onChanged(DocumentChanges what) {
    if (what.testFlag(DocumentChange::Loading)) {
        emit loadingChanged();
    }
    constexpr DocumentChanges kWork = DocumentChange::Opened | DocumentChange::Garment |
                                      DocumentChange::Seams | DocumentChange::Options |
                                      DocumentChange::Results;
    if (what & kWork) {
        upkeep_.note(what);
    }
    if (opening_.isActive()) {
        return;  // what comes is flattened then
    }
    if (!wishes_.empty()) {
        if ((what & (kWork | DocumentChange::Loading)) && jobs_.isUnderWay(change_)) {
            grantWish();  // what is on its way was begun with another state
        }
    } else if (what & kWork) {
        upkeep_.catchUp();
    }
}

void Workspace::onCancelled() {
    if (!isChanging()) {
        upkeep_.onCancelled();
    } else if (!jobs_.isUnderWay(change_)) {
        stopChanging();
        follow();  // what this had taken the place of
    }
}

void Workspace::onFailed() {
    if (!isChanging()) {
        upkeep_.onFailed();
    } else if (!jobs_.isUnderWay(change_)) {
        stopChanging();
        follow();
    }
}

bool Workspace::canUndo() const {
    return !wishes_.empty() || document_.history().canUndo();
}

bool Workspace::canRedo() const {
    return wishes_.empty() && document_.history().canRedo();
}

QString Workspace::undoText() const {
    return wishes_.empty() ? document_.history().undoText() : wishes_.back().text;
}

void Workspace::undo() {
    if (wishes_.empty()) {
        document_.history().undo();
        return;
    }
    wishes_.pop_back();
    if (wishes_.empty() && !opening_.isActive()) {
        jobs_.drop(change_);  // it was on its way
    }
    emit loadingChanged();
    follow();
}

void Workspace::redo() {
    if (wishes_.empty()) {
        document_.history().redo();
    }
}

void Workspace::changeOptions(const QString& text, const FlattenOptions& options) {
    if (!document_.garment()) {
        document_.setOptions(options);
        return;
    }
    DocumentState next = document_.state();
    next.options = options;
    document_.edit(text, std::move(next));
}

void Workspace::setMethod(Method method) {
    FlattenOptions options = document_.options();
    options.method = method;
    changeOptions(tr("Method"), options);
}

void Workspace::setQuality(Quality quality) {
    FlattenOptions options = document_.options();
    options.quality = quality;
    changeOptions(tr("Quality"), options);
}

void Workspace::setBoundarySolver(BoundarySolver solver) {
    FlattenOptions options = document_.options();
    options.boundarySolver = solver;
    changeOptions(tr("Boundary solver"), options);
}

void Workspace::flattenAgain() {
    if (document_.garment() && !isChanging()) {
        upkeep_.want();
        upkeep_.catchUp();
    }
}

void Workspace::setAutoFlatten(bool on) {
    upkeep_.setAutomatic(on);
    if (!isChanging()) {
        upkeep_.catchUp();
    }
}

bool Workspace::canExport() const {
    const PieceResults& results = document_.results();
    return !results.empty() && std::ranges::find(results, nullptr) == results.end();
}

void Workspace::exportTo(const std::filesystem::path& path) {
    Q_ASSERT(canExport());
    writing_.start(exportJob(document_, path, [this](const std::filesystem::path& written) {
        emit exported(textOf(written));
    }));
}

void Workspace::whenWritten(std::function<void()> then) {
    if (writing_.isBusy()) {
        afterWriting_ = std::move(then);
    } else {
        then();
    }
}

Workspace::Paths Workspace::openPaths() const {
    Paths paths;
    if (document_.garment()) {
        for (const auto& file : document_.garment()->files) {
            paths.push_back(file->path);
        }
    }
    return paths;
}

}  // namespace toile
