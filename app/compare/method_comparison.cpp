// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/method_comparison.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/document/document.h"
#include "app/render/scene.h"

namespace toile {

namespace {

constexpr int kPauseMilliseconds = 200;

FlattenOptions withMethod(FlattenOptions options, Method method) {
    options.method = method;
    return options;
}

}  // namespace

MethodComparison::MethodComparison(const Document& document, const JobRunner& ordinary,
                                   QObject* parent)
    : QObject(parent), document_(document), ordinary_(ordinary), runner_(document, this) {
    pause_.setSingleShot(true);
    pause_.setInterval(kPauseMilliseconds);
    connect(&pause_, &QTimer::timeout, this, &MethodComparison::refresh);
    connect(&document_, &Document::changed, this, &MethodComparison::onDocumentChanged);
    connect(&ordinary_, &JobRunner::idle, this, [this] {
        if (isActive_) {
            pause_.start();
        }
    });
    connect(&runner_, &JobRunner::progressed, this, [this](double fraction) {
        workingFraction_ = fraction;
        emit progressed(this->fraction());
    });
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
    isStopped_ = false;
    refresh();
}

void MethodComparison::end() {
    isActive_ = false;
    pause_.stop();
    ++order_;
    runner_.cancel();
    entries_.clear();
    kept_.clear();
    subject_ = {};
    emit changed();
}

void MethodComparison::setMethods(std::vector<Method> methods) {
    methods_ = std::move(methods);
    isStopped_ = false;
    refresh();
}

void MethodComparison::setPiece(int piece) {
    piece_ = piece;
    pieceName_.clear();
    isStopped_ = false;
    refresh();
}

void MethodComparison::stop() {
    isStopped_ = true;
    ++order_;
    runner_.cancel();
    for (Entry& entry : entries_) {
        if (entry.stage == Stage::Waiting || entry.stage == Stage::Working) {
            entry.stage = Stage::Stopped;
        }
    }
    emit changed();
}

void MethodComparison::goOn() {
    isStopped_ = false;
    refresh();
}

bool MethodComparison::isBusy() const {
    return std::ranges::any_of(entries_, [](const Entry& entry) {
        return entry.stage == Stage::Waiting || entry.stage == Stage::Working;
    });
}

double MethodComparison::fraction() const {
    double done = 0;
    for (const Entry& entry : entries_) {
        done += entry.stage == Stage::Working   ? workingFraction_
                : entry.stage == Stage::Waiting ? 0.0
                                                : 1.0;
    }
    return entries_.empty() ? 1.0 : done / static_cast<double>(entries_.size());
}

void MethodComparison::onDocumentChanged(DocumentChanges what) {
    if (!isActive_ || !(what & (DocumentChange::Garment | DocumentChange::Results |
                                DocumentChange::Options | DocumentChange::Seams))) {
        return;
    }
    pause_.start();
}

/// Pieces may have come and gone: the one of the same name is meant.
void MethodComparison::keepPiece() {
    const auto& pieces = subject_.garment->pieces;
    if (!pieceName_.empty()) {
        const auto named = std::ranges::find_if(
            pieces, [this](const auto& piece) -> bool { return piece->name == pieceName_; });
        if (named != pieces.end()) {
            piece_ = static_cast<int>(named - pieces.begin());
        }
    }
    piece_ = std::clamp(piece_, 0, static_cast<int>(pieces.size()) - 1);
    pieceName_ = pieces[static_cast<std::size_t>(piece_)]->name;
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
    if (!subject_.garment || subject_.garment->pieces.empty()) {
        ++order_;
        runner_.cancel();
        entries_.clear();
        emit changed();
        return;
    }
    keepPiece();
    subject_.piece = piece_;
    const bool isSame = subject_ == before;
    if (!isSame) {
        isStopped_ = false;
        forgetOldPieces();
    }
    std::vector<Entry> entries;
    for (const Method method : methods_) {
        const auto had = std::ranges::find(entries_, method, &Entry::method);
        entries.push_back(isSame && had != entries_.end() ? *had : Entry{method});
        if (entries.back().stage == Stage::Stopped) {
            entries.back().stage = Stage::Waiting;
        }
    }
    entries_ = std::move(entries);
    if (runner_.isBusy() && !working()) {
        ++order_;
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
    workingFraction_ = 0;
    const Method method = entry->method;
    const FlattenOptions options = withMethod(subject_.options, method);
    CompareOrder order{subject_.garment, subject_.piece, options, known(options)};
    runner_.start(compareJob(
        std::move(order),
        [this, method, number = ++order_](ComparedPiece made, const PieceResults& results) {
            Entry* done = working();
            if (number == order_ && done && done->method == method) {
                keep(method, results);
                done->made = std::move(made);
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

PieceResults MethodComparison::known(const FlattenOptions& options) const {
    const auto& pieces = subject_.garment->pieces;
    PieceResults results(pieces.size());
    const auto kept = kept_.find(options.method);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto fits = [&](const std::shared_ptr<const PieceResult>& result) -> bool {
            return result && result->piece == pieces[i] && result->options == options;
        };
        if (kept != kept_.end()) {
            if (const auto found = kept->second.find(pieces[i].get());
                found != kept->second.end() && fits(found->second)) {
                results[i] = found->second;
                continue;
            }
        }
        if (i < document_.results().size() && fits(document_.results()[i])) {
            results[i] = document_.results()[i];
        }
    }
    return results;
}

void MethodComparison::keep(Method method, const PieceResults& results) {
    for (const auto& result : results) {
        if (result) {
            kept_[method][result->piece.get()] = result;
        }
    }
}

void MethodComparison::forgetOldPieces() {
    std::set<const Piece*> present;
    for (const auto& piece : subject_.garment->pieces) {
        present.insert(piece.get());
    }
    for (auto& [method, results] : kept_) {
        std::erase_if(results, [&present](const auto& entry) -> bool {
            return !present.contains(entry.first);
        });
    }
}

}  // namespace toile
