// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/method_comparison.h"

#include <algorithm>
#include <utility>

#include "app/document/disposal.h"
#include "app/document/document.h"
#include "app/jobs/job_runner.h"
#include "app/render/scene_builder.h"
#include "app/text/error_text.h"
#include "core/toile/piece_work.h"
#include "core/toile/pipeline.h"

namespace toile::app {

namespace {

constexpr int kPauseMilliseconds = 200;

FlattenOptions withMethod(FlattenOptions options, Method method) {
    options.method = method;
    return options;
}

/// A piece and a method to compare. Snapshot of a job.
struct CompareOrder {
    std::shared_ptr<const Garment> garment;
    int piece = 0;
    FlattenOptions options{};
    PieceResults known{};  ///< one per piece for these options; null if not known
    std::shared_ptr<EndingWorkers> ending{};
};

/// Flattens the piece and its sewn neighbours, unless they are known.
ComparedPiece carriedOut(const CompareOrder& order, Progress& progress) {
    const Garment& garment = *order.garment;
    ComparedPiece made;
    made.all = order.known;
    std::vector<int> needed = sewnTo(garment, order.piece);
    needed.push_back(order.piece);
    std::erase_if(needed, [&](int piece) { return made.all[std::size_t(piece)] != nullptr; });
    Garment part;  // flattening uses the pieces only
    for (const int piece : needed) {
        part.pieces.push_back(garment.pieces[std::size_t(piece)]);
    }
    PieceResults found =
        flattenGarment(part, order.options, progress, 0, {}, {}, order.ending.get());
    for (std::size_t i = 0; i < needed.size(); ++i) {
        made.all[std::size_t(needed[i])] = std::move(found[i]);
    }
    if (progress.isCancelled()) {
        return made;
    }
    made.result = made.all[std::size_t(order.piece)];
    made.figures = comparedPiece(garment, made.all, order.piece);
    if (made.result->flat) {
        Garment alone;
        alone.pieces = {made.result->piece};
        made.scene = buildScene(alone, {made.result}, progress);
    }
    return made;
}

}  // namespace

MethodComparison::MethodComparison(const Document& document, const JobRunner& ordinary,
                                   QObject* parent)
    : QObject(parent),
      document_(document),
      ordinary_(ordinary),
      ending_(sharedForDisposal(std::make_unique<EndingWorkers>())) {
    pause_.setSingleShot(true);
    pause_.setInterval(kPauseMilliseconds);
    connect(&pause_, &QTimer::timeout, this, &MethodComparison::refresh);
    const auto refreshSoon = [this] {
        if (isActive_) {
            pause_.start();
        }
    };
    connect(&document_, &Document::changed, this, [refreshSoon](const DocumentChange& what) {
        if (what.touchesContent() || what.touches(DocumentChange::Selection)) {
            refreshSoon();
        }
    });
    connect(&ordinary_, &JobRunner::idle, this, refreshSoon);
}

void MethodComparison::begin() {
    isActive_ = true;
    refresh();
}

void MethodComparison::end() {
    isActive_ = false;
    pause_.stop();
    worker_.cancel();
    entries_.clear();
    subject_ = {};
    emit changed();
}

void MethodComparison::setMethods(std::vector<Method> methods) {
    methods_ = std::move(methods);
    refresh();
}

bool MethodComparison::isBusy() const {
    return std::ranges::any_of(entries_, [](const Entry& entry) {
        return entry.stage == Stage::Waiting || entry.stage == Stage::Working;
    });
}

/// The selected piece, else the shown one, else the first flat one.
int MethodComparison::chosenPiece() const {
    const Document::Selection& selection = document_.selection();
    const int count = document_.pieceCount();
    if (!selection.empty()) {
        return selection.contains(subject_.piece) ? subject_.piece : *selection.begin();
    }
    if (subject_.piece >= 0 && subject_.piece < count) {
        return subject_.piece;
    }
    const auto flat = std::ranges::find_if(
        document_.results(), [](const auto& result) -> bool { return result && result->flat; });
    const auto first = static_cast<int>(flat - document_.results().begin());
    return first < count ? first : count - 1;
}

/// Keeps valid entries and the job working on one of them.
void MethodComparison::refresh() {
    if (!isActive_) {
        return;
    }
    pause_.stop();
    const Subject before = std::exchange(
        subject_,
        {document_.garment(), withMethod(document_.options(), Method::Isometric), chosenPiece()});
    std::vector<Entry> entries;
    for (const Method method : subject_.piece < 0 ? std::vector<Method>() : methods_) {
        const auto had = std::ranges::find(entries_, method, &Entry::method);
        Entry& entry = entries.emplace_back(Entry{method});
        if (had != entries_.end() && subject_ == before) {
            std::swap(entry, *had);
        } else if (had != entries_.end()) {
            entry.made.all = had->made.all;
        }
    }
    entries_ = std::move(entries);
    if (!firstIn(Stage::Working)) {
        worker_.cancel();
    }
    next();
    emit changed();
}

MethodComparison::Entry* MethodComparison::firstIn(Stage stage) {
    const auto entry = std::ranges::find(entries_, stage, &Entry::stage);
    return entry == entries_.end() ? nullptr : &*entry;
}

void MethodComparison::next() {
    Entry* entry = firstIn(Stage::Waiting);
    if (!isActive_ || !entry || worker_.isBusy() || ordinary_.isBusy()) {
        return;
    }
    entry->stage = Stage::Working;
    const FlattenOptions options = withMethod(subject_.options, entry->method);
    CompareOrder order{subject_.garment, subject_.piece, options, known(entry->made.all, options),
                       ending_};
    worker_.start(
        [order = std::move(order)](Progress& progress) { return carriedOut(order, progress); },
        [this](Attempt<ComparedPiece> made, const Progress& progress) {
            take(std::move(made), progress.isCancelled());
        });
}

/// Outdated jobs are always cancelled, so this result is for the entry in work.
void MethodComparison::take(Attempt<ComparedPiece> made, bool isCancelled) {
    Entry* entry = firstIn(Stage::Working);
    if (entry && isCancelled) {
        entry->stage = Stage::Waiting;
    } else if (entry && !made.answer) {
        entry->stage = Stage::Failed;
        entry->problem = faultText(made.fault);
    } else if (entry) {
        entry->made = *std::move(made.answer);
        entry->stage = Stage::Done;
    }
    next();
    emit changed();
}

/// One per piece: results for these options from the document or an earlier comparison.
PieceResults MethodComparison::known(const PieceResults& before,
                                     const FlattenOptions& options) const {
    PieceResults results;
    for (const auto& piece : subject_.garment->pieces) {
        results.emplace_back();
        for (const PieceResults* found : {&before, &document_.results()}) {
            const auto fits = std::ranges::find_if(*found, [&](const auto& result) -> bool {
                return result && result->piece == piece && result->options == options;
            });
            results.back() = fits != found->end() ? *fits : results.back();
        }
    }
    return results;
}

}  // namespace toile::app
