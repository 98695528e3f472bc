// SPDX-License-Identifier: GPL-3.0-or-later
// This file is long because state, derived values and selection change together and are announced
// once.
#include "app/document/document.h"

#include <QString>
#include <algorithm>
#include <utility>

#include "app/base/text.h"
#include "app/document/history.h"
#include "app/document/shown_proof.h"
#include "core/garment/lineage.h"
#include "core/pattern/pattern.h"
#include "core/pattern/target_lengths.h"
#include "core/project/piece_names.h"
#include "core/seam/seam_settings.h"

namespace toile::app {
namespace {

/// Number of steps that can be undone. States share their common parts, so most cost little.
constexpr int kMaxSteps = 500;

/// The first seam that one of the cuts has made.
std::optional<int> seamOfCuts(const SeamGraph& graph, const std::vector<CutId>& cuts) {
    const auto isOf = [&cuts](const Seam& seam) {
        return std::ranges::any_of(seam.cuts, [&cuts](const CutId cut) {
            return std::ranges::find(cuts, cut) != cuts.end();
        });
    };
    const auto found = std::ranges::find_if(graph.seams, isOf);
    return found == graph.seams.end()
               ? std::nullopt
               : std::optional(static_cast<int>(found - graph.seams.begin()));
}

}  // namespace

Document::Document(QObject* parent) : QObject(parent) {
    history_.setUndoLimit(kMaxSteps);
    connect(&history_, &QUndoStack::indexChanged, this, [this](int index) {
        if (isCurrent()) {
            currentAt_ = index;
        }
    });
}

Document::~Document() {
    history_.blockSignals(true);  // it clears itself when no listeners remain
}

const PieceResult* Document::result(int piece) const {
    const auto at = static_cast<std::size_t>(piece);
    return at < results().size() ? results()[at].get() : nullptr;
}

const PatternPiece* Document::patternPiece(int piece) const {
    const auto at = static_cast<std::size_t>(piece);
    const Pattern* pattern = derived_.pattern.get();
    return pattern && at < pattern->pieces.size() && pattern->pieces[at].outline.rows() > 0
               ? &pattern->pieces[at]
               : nullptr;
}

const ReferenceMatch* Document::reference() const {
    const bool isOfThis = reference_ && reference_->pattern == derived_.pattern &&
                          reference_->file == state_.reference.file;
    return isOfThis ? reference_.get() : nullptr;
}

std::optional<ReferenceFit> Document::referenceFit(int piece) const {
    if (state_.reference.file) {
        const PieceMatch* pair = reference() ? pairOf(reference()->match, piece) : nullptr;
        if (!pair || !isSure(*pair)) {
            return std::nullopt;
        }
        const LineFit& fit = pair->lines.front().fit;
        return ReferenceFit{fit.rms, fit.farthest, fit.mirrored};
    }
    const PieceResult* known = result(piece);
    return known && known->quality ? known->quality->reference : std::nullopt;
}

void Document::showReference(std::shared_ptr<const ReferenceMatch> found) {
    set(reference_, std::move(found), DocumentChange::ReferenceMatch);
}

bool Document::isProofCurrent() const {
    return proof_ && isOfThisPattern(*proof_);
}

bool Document::isOfThisPattern(const ShownProof& shown) const {
    return shown.ground == proofGround(derived_, state_, settings_, shown.plan.sewn);
}

void Document::showProof(std::shared_ptr<const ShownProof> proof) {
    set(proof_, std::move(proof), DocumentChange::Proof);
}

void Document::showSewing(std::shared_ptr<const ShownProof> sewing) {
    set(sewing_, std::move(sewing), DocumentChange::Proof);
}

int Document::pieceCount() const {
    return garment() ? static_cast<int>(garment()->pieces.size()) : 0;
}

std::vector<int> Document::colours() const {
    return garment() ? coloursOf(state_.labels, *garment()) : std::vector<int>{};
}

int Document::colourOf(int piece) const {
    const auto known = state_.labels.find(garment()->pieces[static_cast<std::size_t>(piece)]->id);
    return known == state_.labels.end() ? piece : known->second.colour;
}

Document::Selection Document::everyPiece() const {
    Selection all;
    for (int i = 0; i < pieceCount(); ++i) {
        all.insert(all.end(), i);
    }
    return all;
}

int Document::seamCount() const {
    return garment() ? static_cast<int>(garment()->seams.seams.size()) : 0;
}

QString Document::title() const {
    if (!garment() || garment()->files.empty()) {
        return {};
    }
    const QString first = textOf(garment()->files.front()->path.filename());
    const auto others = static_cast<int>(garment()->files.size()) - 1;
    return others == 0 ? first : tr("%1 and %n more", nullptr, others).arg(first);
}

bool Document::isFlattened() const {
    return isCurrent() && app::isFlattened(derived_, state_);
}

void Document::open(DocumentState state, Derived derived) {
    const DocumentState stateBefore = std::exchange(state_, std::move(state));
    const Derived before = std::exchange(derived_, std::move(derived));
    state_.inputs = derived_.inputs;
    if (garment()) {
        state_.labels = withColours(std::move(state_.labels), nullptr, *garment());
    }
    refreshSettings(true);
    wasFlat_ = isFlattened();
    proof_.reset();
    sewing_.reset();
    cache_.clear();
    history_.clear();
    currentAt_ = 0;
    selection_.clear();
    seam_.reset();
    mark_.reset();
    hover_.reset();
    ++revision_;
    emit opened();
    tell(stateBefore, before, ~0U);
}

void Document::edit(const QString& text, DocumentState next, int gesture) {
    if (next == state_) {
        return;
    }
    if (garment()) {
        history_.push(new StateStep(*this, text, std::move(next), gesture));
    } else {
        exchange(next, wasFlat_);
    }
}

void Document::takeBack(DocumentState rest) {
    const QString text = history_.undoText();
    const bool wentBack = history_.index() < currentAt_;
    const DocumentState stateBefore = state_;
    const Derived before = derived_;
    takesBack_ = true;
    while (history_.index() > currentAt_ && !isCurrent()) {
        history_.undo();  // and removes the step, see StateStep::undo
    }
    while (history_.index() < currentAt_ && history_.canRedo()) {
        history_.redo();
    }
    if (!wentBack || !isCurrent()) {  // an undo that came to nothing makes no step
        edit(text, std::move(rest));
    }
    takesBack_ = false;
    tell(stateBefore, before);
}

void Document::exchange(DocumentState& other, bool& wasFlat) {
    const bool wasCurrent = isCurrent();
    std::swap(state_, other);
    std::swap(wasFlat_, wasFlat);
    Derived derived = knownOf(state_);
    const bool otherPieces = DocumentChange(other, state_, derived_, derived).hasOtherPieces();
    const bool otherReading =
        !(state_.inputs == other.inputs) &&
        (!derived.lines || otherPieces || !wasCurrent || !(derived.inputs == state_.inputs));
    if (otherPieces || otherReading || !(state_.options == other.options) ||
        state_.lines != other.lines ||
        app::leftOut(state_.settings) != app::leftOut(other.settings)) {
        ++revision_;
    }
    tell(other, showOther(std::move(derived)));
}

void Document::tell(const DocumentState& stateBefore, const Derived& before, unsigned parts) {
    if (!takesBack_) {
        emit changed({stateBefore, state_, before, derived_, parts});
    }
}

Derived Document::knownOf(const DocumentState& state) {
    if (!garment()) {
        Derived nothing;
        nothing.inputs = state.inputs;
        return nothing;
    }
    if (derived_.inputs == state.inputs && app::isFlattened(derived_, state)) {
        return derived_;
    }
    cache_.keep(derived_);
    if (const Derived* known = cache_.find(state)) {
        return *known;
    }
    Derived eased = derived_;
    eased.inputs.loading.seamSettings = state.inputs.loading.seamSettings;
    if (eased.inputs == state.inputs) {
        if (auto other = easedGarment(*garment(), state.inputs.loading.seamSettings)) {
            if (drawsEase(*garment()) || drawsEase(*other)) {
                eased.lines.reset();
            }
            eased.garment = std::make_shared<const Garment>(std::move(*other));
            return eased;
        }
    }
    return derived_;
}

Derived Document::showOther(Derived derived) {
    Derived before = std::exchange(derived_, std::move(derived));
    const bool otherPieces = DocumentChange(state_, state_, before, derived_).hasOtherPieces();
    if (otherPieces) {
        state_.labels = withColours(std::move(state_.labels), before.garment.get(), *garment());
        keepSelection(before);
    }
    refreshSettings(otherPieces);
    wasFlat_ = wasFlat_ || isFlattened();
    return before;
}

void Document::refreshSettings(bool otherPieces) {
    const auto count = static_cast<std::size_t>(pieceCount());
    if (otherPieces) {
        settings_.assign(count, {});
    }
    for (std::size_t i = 0; i < count; ++i) {
        // A piece that the coming state does not know keeps its settings.
        if (const auto said = state_.settings.find(garment()->pieces[i]->id);
            said != state_.settings.end()) {
            settings_[i] = said->second;
        }
    }
}

void Document::keepSelection(const Derived& before) {
    Selection kept;
    std::optional<int> seam;
    if (!selection_.empty()) {
        // The pieces that a selected piece was cut into, and the piece that it became part of.
        const auto& pieces = garment()->pieces;
        const std::vector<int> was = predecessors(before.garment->pieces, pieces);
        const std::vector<int> is = predecessors(pieces, before.garment->pieces);
        for (int now = 0; now < pieceCount(); ++now) {
            if (selection_.contains(was[static_cast<std::size_t>(now)])) {
                kept.insert(now);
            }
        }
        for (const int old : selection_) {
            if (is[static_cast<std::size_t>(old)] >= 0) {
                kept.insert(is[static_cast<std::size_t>(old)]);
            }
        }
    }
    if (seam_) {
        const Seam& was = before.garment->seams.seams[static_cast<std::size_t>(*seam_)];
        const int now = seamAt(garment()->seams, was.place);
        seam = now >= 0 ? std::optional(now) : seamOfCuts(garment()->seams, was.cuts);
    }
    // The same indices may mean other pieces now.
    selection_ = std::move(kept);
    seam_ = seam;
    // A piece that was cut has other vertices and edges.
    mark_.reset();
    hover_.reset();
}

void Document::show(Derived derived, SettingsById settings) {
    const DocumentState stateBefore = state_;
    state_.settings = std::move(settings);
    state_.materials = materialsInUse(state_);
    state_.inputs = derived.inputs;
    currentAt_ = history_.index();
    tell(stateBefore, showOther(std::move(derived)));
}

void Document::setOptions(const FlattenOptions& options, const QString& text) {
    edit(text.isEmpty() ? tr("Change method") : text, &DocumentState::options, options);
}

const Fabric& Document::fabricOf(int piece) const {
    return toile::fabricOf(settings_[static_cast<std::size_t>(piece)].material, state_.materials,
                           state_.fabric);
}

void Document::setLines(LineSettings lines, const QString& text, int gesture) {
    if (garment()) {
        edit(text, &DocumentState::lines, std::move(lines), gesture);
    }
}

template <class Value>
void Document::set(Value& field, std::type_identity_t<Value> value, DocumentChange::Part part) {
    if (value != field) {
        field = std::move(value);
        tell(state_, derived_, part);
    }
}

void Document::setSelection(Selection selection) {
    std::erase_if(selection, [this](int piece) { return piece < 0 || piece >= pieceCount(); });
    if (selection.empty()) {
        select({}, seam_, mark_);
    } else {
        select(std::move(selection), {}, {});
    }
}

void Document::select(Selection pieces, std::optional<int> seam, std::optional<Feature> mark) {
    if (pieces != selection_ || seam != seam_ || mark != mark_) {
        selection_ = std::move(pieces);
        seam_ = seam;
        mark_ = mark;
        tell(state_, derived_, DocumentChange::Selection);
    }
}

void Document::toggleSelected(int piece) {
    Selection selection = selection_;
    if (selection.erase(piece) == 0) {
        selection.insert(piece);
    }
    setSelection(std::move(selection));
}

void Document::setSeam(std::optional<int> seam) {
    if (isInGarment(seam)) {
        select({}, seam, {});
    } else {
        select(selection_, {}, mark_);
    }
}

bool Document::isInGarment(std::optional<int> seam) const {
    return seam && *seam >= 0 && *seam < seamCount();
}

bool Document::isInGarment(const Feature& feature) const {
    if (feature.kind == Feature::Kind::Seam) {
        return feature.seam >= 0 && feature.seam < seamCount();
    }
    if (feature.piece < 0 || feature.piece >= pieceCount()) {
        return false;
    }
    const Piece& piece = *garment()->pieces[static_cast<std::size_t>(feature.piece)];
    switch (feature.kind) {
        case Feature::Kind::Run:
            return feature.first >= 0 && feature.count > 0 &&
                   feature.first < static_cast<int>(piece.boundary.size());
        case Feature::Kind::Vertex:
            return feature.vertex >= 0 && feature.vertex < piece.mesh.V.rows() &&
                   feature.face >= 0 && feature.face < piece.mesh.F.rows();
        default:
            return true;
    }
}

void Document::setMark(const std::optional<Feature>& mark, std::optional<int> seam) {
    const bool fits = mark && isInGarment(*mark) &&
                      (mark->kind == Feature::Kind::Run || mark->kind == Feature::Kind::Vertex);
    if (fits) {
        select({}, isInGarment(seam) ? seam : std::nullopt, mark);
    } else {
        select(selection_, seam_, {});
    }
}

void Document::setHover(const std::optional<Feature>& hover) {
    const auto known = hover && isInGarment(*hover) ? hover : std::nullopt;
    if (known != hover_) {
        hover_ = known;
        emit hovered();
    }
}

void Document::setSeamEase(int seam, std::optional<double> ease, int gesture) {
    Q_ASSERT(seam >= 0 && seam < seamCount());
    const auto at = static_cast<std::size_t>(seam);
    const Seam& before = garment()->seams.seams[at];
    if (before.ease == ease) {
        return;
    }
    DocumentState next = state_;
    auto& settings = next.inputs.loading.seamSettings;
    settings = withEase(std::move(settings), before, ease);
    edit(tr("Set ease of %1").arg(seamName(*this, seam)), std::move(next), gesture);
}

void Document::setEaseDrawn(int seam, bool drawn) {
    Q_ASSERT(seam >= 0 && seam < seamCount());
    const Seam& before = garment()->seams.seams[static_cast<std::size_t>(seam)];
    if (!before.ease || before.drawn.has_value() == drawn) {
        return;
    }
    DocumentState next = state_;
    auto& settings = next.inputs.loading.seamSettings;
    settings = withEase(std::move(settings), before, before.ease,
                        drawn ? std::optional(SeamPart{}) : std::nullopt);
    const QString text = drawn ? tr("Draw ease of %1") : tr("Do not draw ease of %1");
    edit(text.arg(seamName(*this, seam)), std::move(next));
}

void Document::setView(const ViewState& view) {
    set(view_, view, DocumentChange::View);
}

void Document::setView(bool ViewState::*field, bool on) {
    ViewState view = view_;
    view.*field = on;
    setView(view);
}

void Document::setOverlay(Overlay overlay) {
    ViewState view = view_;
    view.overlay = overlay;
    setView(view);
}

QString pieceName(const Document& document, int piece) {
    return QString::fromStdString(nameOf(
        document.state().labels, *document.garment()->pieces[static_cast<std::size_t>(piece)]));
}

QString seamName(const Document& document, int seam) {
    const Garment& garment = *document.garment();
    return QString::fromStdString(nameOf(document.state().labels, garment,
                                         garment.seams.seams[static_cast<std::size_t>(seam)]));
}

QString nameOfPieces(const Document& document, const std::vector<int>& pieces) {
    return pieces.size() == 1 ? pieceName(document, pieces.front())
                              : tr("%n pieces", nullptr, static_cast<int>(pieces.size()));
}

QString stepOf(const Document& document, const QString& text, const std::vector<int>& pieces) {
    return QString(text).replace("%1", nameOfPieces(document, pieces));
}

}  // namespace toile::app
