// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"

#include <QString>
#include <algorithm>
#include <utility>

#include "app/base/path_text.h"
#include "app/document/disposal.h"
#include "app/document/history.h"
#include "core/garment/lineage.h"
#include "core/pipeline/garment_flattener.h"
#include "core/seam/seam_settings.h"

namespace toile {
namespace {

/// Steps that can be undone. States share what they have in common, so most cost little.
constexpr int kMostSteps = 500;

bool isOfTheSameFiles(const Garment& a, const Garment& b) {
    return std::equal(
        a.files.begin(), a.files.end(), b.files.begin(), b.files.end(),
        [](const auto& one, const auto& other) -> bool { return one->path == other->path; });
}

bool haveTheSamePieces(const Garment* a, const Garment* b) {
    return a && b && a->pieces == b->pieces;
}

}  // namespace

Document::Document(QObject* parent)
    : QObject(parent), flattener_(sharedForDisposal(std::make_unique<GarmentFlattener>())) {
    history_.setUndoLimit(kMostSteps);
}

Document::~Document() {
    history_.blockSignals(true);  // it clears itself, and who listened may be gone
}

const PieceResult* Document::result(int piece) const {
    const auto at = static_cast<std::size_t>(piece);
    return at < results().size() ? results()[at].get() : nullptr;
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

void Document::open(DocumentState state) {
    // What was open before must leave no trace in another garment's results.
    if (!garment() || !state.garment || !isOfTheSameFiles(*garment(), *state.garment)) {
        flattener_ = sharedForDisposal(std::make_unique<GarmentFlattener>());
    }
    state_ = std::move(state);
    state_.settings.resize(static_cast<std::size_t>(pieceCount()));
    if (garment()) {
        state_.labels = withColours(std::move(state_.labels), nullptr, *garment());
    }
    history_.clear();
    selection_.clear();
    seam_.reset();
    mark_.reset();
    hover_.reset();
    ++revision_;
    emit changed(DocumentChange::Opened | DocumentChange::Garment | DocumentChange::Results |
                 DocumentChange::Selection | DocumentChange::Mark | DocumentChange::Hover |
                 DocumentChange::Seams | DocumentChange::SeamSelection | DocumentChange::Loading |
                 DocumentChange::Options | DocumentChange::Fabric | DocumentChange::Settings);
}

void Document::setGarment(std::shared_ptr<const Garment> garment,
                          std::shared_ptr<const Scene> scene) {
    DocumentState next;
    next.garment = std::move(garment);
    next.loading = state_.loading;
    next.options = state_.options;
    next.fabric = state_.fabric;
    next.scene = std::move(scene);
    open(std::move(next));
}

void Document::edit(const QString& text, DocumentState next, int gesture) {
    next.settings.resize(next.garment ? next.garment->pieces.size() : 0);
    if (next.garment && next.garment != garment()) {
        next.labels = withColours(std::move(next.labels), garment().get(), *next.garment);
    }
    if (next == state_) {
        return;
    }
    history_.push(new StateStep(*this, text, std::move(next), gesture));
}

void Document::exchange(DocumentState& other) {
    std::swap(state_, other);
    const DocumentState& before = other;
    DocumentChanges what = differences(before);
    if (what.testFlag(DocumentChange::Garment)) {
        what |= keepSelection(before);
    }
    if (what & (DocumentChange::Garment | DocumentChange::Options)) {
        ++revision_;
    }
    emit changed(what);
}

DocumentChanges Document::differences(const DocumentState& before) const {
    DocumentChanges what;
    what.setFlag(DocumentChange::Garment,
                 !haveTheSamePieces(state_.garment.get(), before.garment.get()));
    what.setFlag(DocumentChange::Seams, state_.garment != before.garment);
    what.setFlag(DocumentChange::Results,
                 state_.results != before.results || state_.scene != before.scene);
    what.setFlag(DocumentChange::Loading, !(state_.loading == before.loading));
    what.setFlag(DocumentChange::Options, !(state_.options == before.options));
    what.setFlag(DocumentChange::Fabric, !(state_.fabric == before.fabric));
    what.setFlag(DocumentChange::Settings,
                 state_.settings != before.settings || state_.labels != before.labels);
    return what;
}

DocumentChanges Document::keepSelection(const DocumentState& before) {
    Selection kept;
    std::optional<int> seam;
    if (garment() && before.garment && !selection_.empty()) {
        // What a selected piece was cut into, and what it became part of.
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
    if (garment() && before.garment && seam_) {
        const auto& seams = before.garment->seams.seams;
        const int now = seamAt(garment()->seams, seams[static_cast<std::size_t>(*seam_)].place);
        seam = now >= 0 ? std::optional(now) : std::nullopt;
    }
    // The indices may mean others now even where they are the same numbers.
    selection_ = std::move(kept);
    seam_ = seam;
    // Vertices and edges are others in a piece that was cut.
    mark_.reset();
    hover_.reset();
    return DocumentChange::Selection | DocumentChange::SeamSelection | DocumentChange::Mark |
           DocumentChange::Hover;
}

void Document::setResults(PieceResults results, std::shared_ptr<const Scene> scene) {
    setResults(std::move(results), std::move(scene), settings());
}

void Document::setResults(PieceResults results, std::shared_ptr<const Scene> scene,
                          std::vector<PieceSettings> settings) {
    Q_ASSERT(static_cast<int>(results.size()) == pieceCount());
    Q_ASSERT(static_cast<int>(settings.size()) == pieceCount());
    DocumentChanges what = DocumentChange::Results;
    what.setFlag(DocumentChange::Settings, settings != state_.settings);
    state_.results = std::move(results);
    state_.scene = std::move(scene);
    state_.settings = std::move(settings);
    state_.letGo = false;
    emit changed(what);
}

void Document::setScene(std::shared_ptr<const Scene> scene) {
    state_.scene = std::move(scene);
    emit changed(DocumentChange::Results);
}

const DocumentState& Document::keptState(int step) const {
    return static_cast<const StateStep*>(history_.command(step))->other();
}

void Document::letGo(int step, bool results) {
    static_cast<const StateStep*>(history_.command(step))->letGo(results);
}

void Document::setOptions(const FlattenOptions& options) {
    if (options == state_.options) {
        return;
    }
    if (garment()) {
        DocumentState next = state_;
        next.options = options;
        edit(tr("Change of method"), std::move(next));
        return;
    }
    state_.options = options;
    ++revision_;
    emit changed(DocumentChange::Options);
}

void Document::setLoading(LoadOptions loading) {
    Q_ASSERT(!garment());
    state_.loading = std::move(loading);
    emit changed(DocumentChange::Loading);
}

void Document::setSelection(Selection selection) {
    std::erase_if(selection, [this](int piece) { return piece < 0 || piece >= pieceCount(); });
    if (selection == selection_) {
        return;
    }
    selection_ = std::move(selection);
    emit changed(DocumentChange::Selection);
}

void Document::toggleSelected(int piece) {
    Selection selection = selection_;
    if (selection.erase(piece) == 0) {
        selection.insert(piece);
    }
    setSelection(std::move(selection));
}

void Document::setSeam(std::optional<int> seam) {
    if (seam && (*seam < 0 || *seam >= seamCount())) {
        seam.reset();
    }
    if (seam == seam_) {
        return;
    }
    seam_ = seam;
    emit changed(DocumentChange::SeamSelection);
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

void Document::setMark(std::optional<Feature> mark) {
    const bool fits = mark && isInGarment(*mark) &&
                      (mark->kind == Feature::Kind::Run || mark->kind == Feature::Kind::Vertex);
    if (!fits) {
        mark.reset();
    }
    if (mark == mark_) {
        return;
    }
    mark_ = mark;
    emit changed(DocumentChange::Mark);
}

void Document::setHover(std::optional<Feature> hover) {
    if (hover && !isInGarment(*hover)) {
        hover.reset();
    }
    if (hover == hover_) {
        return;
    }
    hover_ = hover;
    emit changed(DocumentChange::Hover);
}

void Document::setSeamEase(int seam, std::optional<double> ease) {
    Q_ASSERT(seam >= 0 && seam < seamCount());
    const auto at = static_cast<std::size_t>(seam);
    const Seam& before = garment()->seams.seams[at];
    if (before.ease == ease) {
        return;
    }
    // Jobs and the views may hold the garment as it was, so it is not touched.
    auto eased = std::make_shared<Garment>(*garment());
    eased->seams.seams[at].ease = ease;
    DocumentState next = state_;
    eased->seamSettings = withEase(eased->seamSettings, before, ease);
    next.loading.seamSettings = eased->seamSettings;
    next.garment = std::move(eased);
    edit(tr("Ease of a seam"), std::move(next));
}

void Document::setView(const ViewState& view) {
    if (view != view_) {
        view_ = view;
        emit changed(DocumentChange::View);
    }
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

}  // namespace toile
