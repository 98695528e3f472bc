// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/workspace.h"

#include <algorithm>
#include <utility>

#include "app/base/text.h"
#include "app/jobs/derivation.h"
#include "app/jobs/file_jobs.h"
#include "app/jobs/garment_jobs.h"
#include "app/session/cut_proposals.h"
#include "app/session/pattern_proof.h"
#include "app/text/error_text.h"
#include "core/assemble/identify.h"

namespace toile::app {

Workspace::Workspace(QObject* parent) : QObject(parent) {
    proposals_ = std::make_unique<CutProposals>(*this);
    proof_ = std::make_unique<PatternProof>(document_, proving_);
    connect(&document_, &Document::changed, this, &Workspace::onChanged);
    connect(&document_.history(), &QUndoStack::indexChanged, this, [this](int index) {
        opening_.noteEdit();
        if (index < std::exchange(step_, index)) {
            recompute_.retry();
            follow();
        }
    });
    recompute_.setObjection([this](const Garment& garment, DocumentState& rest) {
        return cuts_.objectionTo(garment, rest);
    });
    connect(&recompute_, &Recompute::refused, &cuts_, &CutEditor::refuse);
    connect(&cuts_, &CutEditor::refused, this, &Workspace::refused);
    connect(&cuts_, &CutEditor::noted, this, &Workspace::noted);
    connect(&reference_, &ReferenceFinder::paired, this, &Workspace::noted);
    // A replaced job says nothing about the present request.
    connect(&jobs_, &JobRunner::failed, this,
            [this](const QString&, const QString&, bool replaced) {
                if (!replaced) {
                    onStopped(true);
                }
            });
    connect(&jobs_, &JobRunner::cancelled, this, [this](const QString&, bool replaced) {
        if (!replaced) {
            onStopped(false);
        }
    });
    for (const JobRunner* makers : {&cuts_.searches(), &jobs_}) {
        connect(makers, &JobRunner::started, this, &Workspace::followAge);
        connect(makers, &JobRunner::idle, this, &Workspace::followAge);
    }
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
    proposals_->close();
    cuts_.searches().shutdown();
    jobs_.shutdown();
    proving_.shutdown();
    writing_.finish();
}

bool Workspace::canUndo() const {
    return cuts_.searches().lastUnderWay() != 0 || proposals_->hasMoves() ||
           document_.history().canUndo();
}

void Workspace::undo() {
    if (const JobRunner::Ticket last = cuts_.searches().lastUnderWay()) {
        cuts_.searches().drop(last);
    } else if (!proposals_->takeMoveBack()) {
        document_.history().undo();
    }
}

void Workspace::cancel() {
    if (cuts_.searches().lastUnderWay()) {
        cuts_.searches().cancel();
        return;
    }
    if (!jobs_.isBusy()) {
        (proving_.isBusy() ? proving_ : writing_).cancel();
        return;
    }
    jobs_.cancel();
    onStopped(false);  // requests made until the job stops are not cancelled with it
}

void Workspace::startReading(std::unique_ptr<Job> job) {
    recompute_.yield();
    reading_ = jobs_.replace(std::move(job));
}

void Workspace::open(Paths files) {
    if (files.empty()) {
        return;
    }
    const bool another = opening_.isActive() && !opening_.files();
    const Paths before = opening_.files() ? opening_.files()->paths : openPaths();
    // Settings changed while another garment is read belong to that one.
    Opening::Files coming{std::move(files), another ? document_.loading() : loading()};
    if (!before.empty() && coming.paths != before) {
        coming.loading = {};  // stated for the garment before
    }
    if (document_.garment() && coming.paths == openPaths()) {
        coming.loading.known = knownPieces(*document_.garment());  // the files may have changed
    }
    forOpening_.clear();
    opening_.begin(std::move(coming));
    startOpening();
}

void Workspace::startOpening() {
    emit loadingChanged();
    const Opening::Files& files = *opening_.files();
    startReading(importJob(files.paths, files.loading, [this](const Derived& made) {
        // Settings of one garment do not apply to another.
        const bool again = opening_.files()->paths == openPaths();
        arrived([this, again, made] {
            const bool isAnother = document_.garment() && !again;
            DocumentState next;
            next.lines = newLines_;
            next.settings = settingsOfNew(*made.garment);
            if (!isAnother) {
                next.options = document_.options();
                next.proof = document_.state().proof;
                next.fabric = document_.fabric();
            }
            next.materials = materialsInUse(next);
            document_.open(std::move(next), made);
            if (isAnother) {
                document_.setView(viewOfNext(document_.view()));
            }
        });
    }));
}

void Workspace::openBy(std::unique_ptr<Job> reading) {
    forOpening_.clear();
    opening_.begin();
    emit loadingChanged();
    startReading(std::move(reading));
}

void Workspace::arrived(std::function<void()> open) {
    const Opening::Next next = opening_.arrive(
        [this, open = std::move(open), changes = std::exchange(forOpening_, {})]() mutable {
            open();
            for (LoadingChange& change : changes) {
                changeLoading(std::move(change));
            }
            follow();
        });
    emit loadingChanged();
    next();
    follow();  // not opened: the reading had replaced this
}

void Workspace::notOpened() {
    stopReading();
    follow();
}

void Workspace::stopReading() {
    if (opening_.isActive()) {
        opening_.stop();
        forOpening_.clear();
        emit loadingChanged();
    }
}

void Workspace::follow() {
    if (!isReading()) {
        recompute_.catchUp();
    }
}

void Workspace::onChanged(const DocumentChange& what) {
    if (what.touches(&DocumentState::inputs)) {
        emit loadingChanged();
    }
    if (what.touchesContent()) {
        follow();
    }
    followAge();
}

PatternAge Workspace::patternAge() const {
    return !document_.garment() || document_.isFlattened() ? PatternAge::UpToDate
           : cuts_.searches().isBusy() || jobs_.isBusy()   ? PatternAge::Renewed
                                                           : PatternAge::OutOfDate;
}

void Workspace::followAge() {
    if (const PatternAge age = patternAge(); age != std::exchange(age_, age)) {
        emit patternAged(age);
    }
}

void Workspace::onStopped(bool failed) {
    if (!opening_.isActive()) {
        recompute_.onStopped(failed);
    } else if (!jobs_.isUnderWay(reading_)) {
        stopReading();
    }
    follow();  // begin again what the job had replaced
}

template <class Value>
void Workspace::setOption(const QString& text, Value FlattenOptions::*field, Value value) {
    FlattenOptions options = document_.options();
    options.*field = value;
    document_.setOptions(options, text);
}

void Workspace::setMethod(Method method) {
    setOption(tr("Change method"), &FlattenOptions::method, method);
}

void Workspace::setQuality(Quality quality) {
    setOption(tr("Change quality"), &FlattenOptions::quality, quality);
}

void Workspace::setBoundarySolver(BoundarySolver solver) {
    setOption(tr("Change boundary solver"), &FlattenOptions::boundarySolver, solver);
}

void Workspace::flattenAgain() {
    if (document_.garment() && !opening_.isActive()) {
        recompute_.want();
        follow();
    }
}

void Workspace::setAutoFlatten(bool on) {
    recompute_.setAutomatic(on);
    follow();
}

void Workspace::holdFlattening(bool held) {
    recompute_.setHeld(held);
    follow();
}

const LoadOptions& Workspace::loading() const {
    return opening_.files() ? opening_.files()->loading : document_.loading();
}

void Workspace::reload() {
    if (opening_.files()) {
        startOpening();
        return;
    }
    if (!document_.garment() || opening_.isActive()) {
        return;
    }
    startReading(readingJob(openPaths(), [this](ReadFiles files) {
        reading_ = 0;
        DocumentState next = document_.state();
        next.inputs.files = std::move(files);
        next.inputs.loading.known = knownPieces(*document_.garment());
        document_.edit(tr("Reload"), std::move(next));
        follow();
    }));
}

void Workspace::setLoading(LoadOptions loading) {
    changeLoading({tr("Change import options"),
                   [loading = std::move(loading)](LoadOptions& options) { options = loading; }});
}

template <class Value>
void Workspace::setLoadingField(const QString& text, Value LoadOptions::*field,
                                const Value& value) {
    changeLoading({text, [field, value](LoadOptions& options) { options.*field = value; }});
}

void Workspace::setUnit(std::optional<FileUnit> unit) {
    setLoadingField(tr("Change unit"), &LoadOptions::unit, unit);
}

void Workspace::setUpAxis(std::optional<UpAxis> up) {
    setLoadingField(tr("Change up axis"), &LoadOptions::up, up);
}

void Workspace::setPreparing(Preparation preparing) {
    setLoadingField(tr("Change import options"), &LoadOptions::preparing, preparing);
}

void Workspace::tryPreparing(Preparation preparing, int gesture) {
    changeLoading({tr("Change import options"),
                   [preparing](LoadOptions& options) { options.preparing = preparing; }, gesture});
}

void Workspace::setSplit(SplitMode split) {
    setLoadingField(tr("Change splitting into pieces"), &LoadOptions::split, split);
}

void Workspace::setAutoCut(bool on) {
    setLoadingField(tr("Change automatic cuts"), &LoadOptions::autoCut, on);
}

void Workspace::setCutStyle(CutStyle style) {
    changeLoading({tr("Change automatic cuts"), [style](LoadOptions& options) {
                       options.cutStyle = style;
                       options.autoCut = options.autoCut || style != CutStyle::Topology;
                   }});
}

void Workspace::setWeld(bool on) {
    setLoadingField(tr("Change welding"), &LoadOptions::weld, on);
}

void Workspace::setCloseSlits(bool on) {
    setLoadingField(tr("Change closing of slits"), &LoadOptions::closeSlits, on);
}

void Workspace::changeLoading(LoadingChange change) {
    if (opening_.isActive() && !opening_.files()) {
        // The coming garment is not known yet.
        forOpening_.push_back(std::move(change));
        return;
    }
    const LoadOptions before = loading();
    LoadOptions after = before;
    change.change(after);
    if (after == before) {
        return;
    }
    if (opening_.files()) {
        opening_.files()->loading = std::move(after);
        startOpening();
        return;
    }
    LoadOptions cutAlike = after;
    cutAlike.seams = before.seams;
    cutAlike.autoCut = before.autoCut;
    cutAlike.cutStyle = before.cutStyle;
    if (document_.garment() && document_.isCurrent() && !(cutAlike == before)) {
        after.known = knownPieces(*document_.garment());  // the files are divided again
    }
    DocumentState next = document_.state();
    next.inputs.loading = std::move(after);
    document_.edit(change.text, std::move(next), change.gesture);
}

bool Workspace::canExport() const {
    const PieceResults& results = document_.results();
    return std::ranges::find(results, nullptr) == results.end() &&
           std::ranges::any_of(results,
                               [](const auto& result) { return result->flat.has_value(); });
}

void Workspace::exportTo(const std::filesystem::path& path, const ExportOptions& options,
                         const Document::Selection& only) {
    Q_ASSERT(canExport());
    writing_.start(exportJob(document_, path, options, only, [this](const Exported& written) {
        QStringList said;
        if (written.readBack) {
            said << readBackText(*written.readBack);
        }
        for (const Wording& note : written.notes) {
            said << wordingText(note);
        }
        emit exported(textOf(written.files.front()), said.join("; "));
    }));
}

JobRunner::Ticket Workspace::beginFile(FormatId format, const ExportOptions& options,
                                       const Document::Selection& only,
                                       std::function<void(const std::string&)> done) {
    Q_ASSERT(canExport());
    return writing_.start(beginningJob(document_, format, options, only, std::move(done)));
}

JobRunner::Ticket Workspace::drawPattern(
    std::function<void(std::shared_ptr<const DrawnPattern>)> done,
    const Document::Selection& only) {
    Q_ASSERT(canExport());
    return writing_.start(drawingJob(document_, only, std::move(done)));
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

void Workspace::openReference(const std::filesystem::path& path) {
    if (!document_.garment() || opening_.isActive()) {
        return;
    }
    startReading(referenceJob(path, [this](ReferenceFile read) {
        reading_ = 0;
        document_.setView(&ViewState::referencePanels, true);  // show what was opened
        document_.edit(tr("Open reference pattern"), &DocumentState::reference, std::move(read));
        follow();
    }));
}

void Workspace::closeReference() {
    document_.edit(tr("Close reference pattern"), &DocumentState::reference, {});
}

}  // namespace toile::app
