// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/method_comparison.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/document/disposal.h"
#include "app/document/document.h"
#include "app/render/scene_builder.h"
#include "core/toile/piece_work.h"
#include "core/toile/pipeline.h"

namespace toile::app {

namespace {

constexpr int kPauseMilliseconds = 200;
/// Of a method's time, about; the rest builds the scene.
constexpr double kComparingShare = 0.8;

FlattenOptions withMethod(FlattenOptions options, Method method) {
    options.method = method;
    return options;
}

/// What to make of one piece by one method. Snapshot of a job.
struct CompareOrder {
    std::shared_ptr<const Garment> garment;
    int piece = 0;
    FlattenOptions options{};
    PieceResults known{};  ///< one per piece: by these options; null where it is not known
    std::shared_ptr<EndingWorkers> ending{};
};

struct Compared {
    ComparedPiece piece;
    PieceResults results;  ///< one per piece of the garment; null where it was of no interest
};

/// What is known, and the piece and those sewn to it.
PieceResults flattened(const CompareOrder& order, Progress& progress) {
    PieceResults results = order.known;
    std::vector<int> needed = sewnTo(*order.garment, order.piece);
    needed.push_back(order.piece);
    std::erase_if(needed,
                  [&](int piece) { return results[static_cast<std::size_t>(piece)] != nullptr; });
    Garment part;  // flattening looks at the pieces alone
    for (const int piece : needed) {
        part.pieces.push_back(order.garment->pieces[static_cast<std::size_t>(piece)]);
    }
    PieceResults found =
        flattenGarment(part, order.options, progress, 0, {}, {}, order.ending.get());
    for (std::size_t i = 0; i < needed.size(); ++i) {
        results[static_cast<std::size_t>(needed[i])] = std::move(found[i]);
    }
    return results;
}

Result<Compared> carriedOut(const CompareOrder& order, Progress& progress) {
    progress.setShare(0, kComparingShare);
    Compared made{{}, flattened(order, progress)};
    if (!progress.isCancelled()) {
        progress.setShare(kComparingShare, 1);
        ComparedPiece& piece = made.piece;
        piece.result = made.results[static_cast<std::size_t>(order.piece)];
        piece.figures = comparedPiece(*order.garment, made.results, order.piece);
        if (piece.result->flat) {
            Garment alone;
            alone.pieces = {piece.result->piece};
            piece.scene = buildScene(alone, {piece.result}, progress);
        }
    }
    return made;
}

}  // namespace

MethodComparison::MethodComparison(const Document& document, const JobRunner& ordinary,
                                   QObject* parent)
    : QObject(parent),
      document_(document),
      ordinary_(ordinary),
      runner_(this),
      ending_(sharedForDisposal(std::make_unique<EndingWorkers>())) {
    pause_.setSingleShot(true);
    pause_.setInterval(kPauseMilliseconds);
    connect(&pause_, &QTimer::timeout, this, &MethodComparison::refresh);
    connect(&document_, &Document::changed, this, &MethodComparison::onDocumentChanged);
    connect(&ordinary_, &JobRunner::idle, this, [this] {
        if (isActive_) {
            pause_.start();
        }
    });
    connect(&runner_, &JobRunner::progressed, this, [this] { emit progressed(fraction()); });
    connect(&runner_, &JobRunner::failed, this, [this](const QString&, const QString& sentence) {
        if (Entry* entry = working()) {
            entry->stage = Stage::Failed;
            entry->problem = sentence;
        }
    });
    connect(&runner_, &JobRunner::idle, this, &MethodComparison::onIdle);
}

void MethodComparison::begin() {
    isActive_ = true;
    goOn();
}

void MethodComparison::end() {
    isActive_ = false;
    pause_.stop();
    runner_.cancel();
    entries_.clear();
    kept_.clear();
    subject_ = {};
    emit changed();
}

void MethodComparison::setMethods(std::vector<Method> methods) {
    methods_ = std::move(methods);
    goOn();
}

void MethodComparison::setPiece(int piece) {
    piece_ = piece;
    pieceName_.clear();
    goOn();
}

void MethodComparison::stop() {
    isStopped_ = true;
    runner_.cancel();
    if (Entry* entry = working()) {
        entry->stage = Stage::Waiting;
    }
    emit changed();
}

void MethodComparison::goOn() {
    isStopped_ = false;
    refresh();
}

bool MethodComparison::isBusy() const {
    return !isStopped_ && std::ranges::any_of(entries_, [](const Entry& entry) {
        return entry.stage == Stage::Waiting || entry.stage == Stage::Working;
    });
}

double MethodComparison::fraction() const {
    double done = 0;
    for (const Entry& entry : entries_) {
        done += entry.stage == Stage::Working   ? runner_.fraction()
                : entry.stage == Stage::Waiting ? 0.0
                                                : 1.0;
    }
    return entries_.empty() ? 1.0 : done / static_cast<double>(entries_.size());
}

void MethodComparison::onDocumentChanged(DocumentChanges what) {
    if (isActive_ && (what & (DocumentChange::Garment | DocumentChange::Results |
                              DocumentChange::Options | DocumentChange::Seams))) {
        pause_.start();
    }
}

/// Pieces may have come and gone: the one of the same name is meant.
void MethodComparison::choosePiece() {
    const auto& pieces = subject_.garment->pieces;
    const auto named = std::ranges::find_if(
        pieces, [this](const auto& piece) -> bool { return piece->name == pieceName_; });
    if (!pieceName_.empty() && named != pieces.end()) {
        piece_ = static_cast<int>(named - pieces.begin());
    }
    piece_ = std::clamp(piece_, 0, static_cast<int>(pieces.size()) - 1);
    pieceName_ = pieces[static_cast<std::size_t>(piece_)]->name;
    subject_.piece = piece_;
}

/// Brings the entries to what is asked now; those that still hold stay, and so does the job on its
/// way where it is still wanted.
void MethodComparison::refresh() {
    if (!isActive_) {
        return;
    }
    pause_.stop();
    const Subject before = std::exchange(
        subject_, {document_.garment(), withMethod(document_.options(), Method::Isometric), -1});
    const bool isEmpty = !subject_.garment || subject_.garment->pieces.empty();
    if (!isEmpty) {
        choosePiece();
    }
    const bool isSame = subject_ == before;
    isStopped_ = isStopped_ && isSame;
    std::vector<Entry> entries;
    for (const Method method : isEmpty ? std::vector<Method>() : methods_) {
        const auto had = std::ranges::find(entries_, method, &Entry::method);
        entries.push_back(isSame && had != entries_.end() ? *had : Entry{method});
    }
    entries_ = std::move(entries);
    if (!working()) {
        runner_.cancel();
    }
    next();
    emit changed();
}

MethodComparison::Entry* MethodComparison::working() {
    const auto entry = std::ranges::find(entries_, Stage::Working, &Entry::stage);
    return entry == entries_.end() ? nullptr : &*entry;
}

void MethodComparison::next() {
    if (!isActive_ || isStopped_ || runner_.isBusy() || ordinary_.isBusy()) {
        return;
    }
    const auto entry = std::ranges::find(entries_, Stage::Waiting, &Entry::stage);
    if (entry == entries_.end()) {
        return;
    }
    entry->stage = Stage::Working;
    const FlattenOptions options = withMethod(subject_.options, entry->method);
    CompareOrder order{subject_.garment, subject_.piece, options, known(options), ending_};
    // Whatever makes the result unwanted cancels the job: what comes is of the entry in work.
    runner_.start(makeJob(
        tr("Comparing methods"),
        [order = std::move(order)](Progress& progress) { return carriedOut(order, progress); },
        [this](Compared made) {
            keep(made.results);
            if (Entry* done = working()) {
                done->made = std::move(made.piece);
                done->stage = Stage::Done;
            }
        }));
}

void MethodComparison::onIdle() {
    // Cancelled by what came meanwhile, and wanted again.
    if (Entry* entry = working()) {
        entry->stage = Stage::Waiting;
    }
    next();
    emit changed();
}

/// One per piece: what the document or an earlier comparison found by these options.
PieceResults MethodComparison::known(const FlattenOptions& options) const {
    PieceResults results;
    for (const auto& piece : subject_.garment->pieces) {
        results.emplace_back();
        for (const PieceResults* found : {&kept_, &document_.results()}) {
            const auto fits = std::ranges::find_if(*found, [&](const auto& result) -> bool {
                return result && result->piece == piece && result->options == options;
            });
            if (fits != found->end()) {
                results.back() = *fits;
                break;
            }
        }
    }
    return results;
}

/// In place of what the same methods made of the same pieces before. Pieces that the garment has no
/// more are forgotten.
void MethodComparison::keep(const PieceResults& results) {
    const auto& present = subject_.garment->pieces;
    std::erase_if(kept_, [&](const auto& old) -> bool {
        const bool isReplaced = std::ranges::any_of(results, [&](const auto& result) -> bool {
            return result && result->piece == old->piece &&
                   result->options.method == old->options.method;
        });
        return isReplaced || std::ranges::find(present, old->piece) == present.end();
    });
    std::ranges::copy_if(results, std::back_inserter(kept_),
                         [](const auto& result) -> bool { return result != nullptr; });
}

}  // namespace toile::app
