// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"

#include <QString>
#include <algorithm>
#include <utility>

#include "core/pipeline/garment_flattener.h"

namespace toile {
namespace {

bool isOfTheSameFiles(const Garment& a, const Garment& b) {
    return std::equal(
        a.files.begin(), a.files.end(), b.files.begin(), b.files.end(),
        [](const auto& one, const auto& other) -> bool { return one->path == other->path; });
}

}  // namespace

Document::Document(QObject* parent)
    : QObject(parent), flattener_(std::make_shared<GarmentFlattener>()) {}

Document::~Document() = default;

int Document::pieceCount() const {
    return garment_ ? static_cast<int>(garment_->pieces.size()) : 0;
}

int Document::seamCount() const {
    return garment_ ? static_cast<int>(garment_->seams.seams.size()) : 0;
}

QString Document::title() const {
    if (!garment_ || garment_->files.empty()) {
        return {};
    }
    const QString first =
        QString::fromStdU16String(garment_->files.front()->path.filename().u16string());
    const auto others = static_cast<int>(garment_->files.size()) - 1;
    return others == 0 ? first : tr("%1 and %n more", nullptr, others).arg(first);
}

void Document::setGarment(std::shared_ptr<const Garment> garment,
                          std::shared_ptr<const Scene> scene) {
    // What was open before must leave no trace in another garment's results.
    if (!garment_ || !garment || !isOfTheSameFiles(*garment_, *garment)) {
        flattener_ = std::make_shared<GarmentFlattener>();
    }
    garment_ = std::move(garment);
    scene_ = std::move(scene);
    results_.clear();
    selection_.clear();
    seam_.reset();
    ++revision_;
    emit changed(DocumentChange::Garment | DocumentChange::Results | DocumentChange::Selection |
                 DocumentChange::Seams | DocumentChange::SeamSelection);
}

void Document::setResults(PieceResults results, std::shared_ptr<const Scene> scene) {
    Q_ASSERT(static_cast<int>(results.size()) == pieceCount());
    results_ = std::move(results);
    scene_ = std::move(scene);
    emit changed(DocumentChange::Results);
}

void Document::setOptions(const FlattenOptions& options) {
    if (options == options_) {
        return;
    }
    options_ = options;
    ++revision_;
    emit changed(DocumentChange::Options);
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

void Document::setSeamEase(int seam, std::optional<double> ease) {
    Q_ASSERT(seam >= 0 && seam < seamCount());
    const auto at = static_cast<std::size_t>(seam);
    if (garment_->seams.seams[at].ease == ease) {
        return;
    }
    // Jobs and the views may hold the garment as it was, so it is not touched.
    auto garment = std::make_shared<Garment>(*garment_);
    garment->seams.seams[at].ease = ease;
    garment_ = std::move(garment);
    emit changed(DocumentChange::Seams);
}

void Document::setOverlay(Overlay overlay) {
    if (view_.overlay == overlay) {
        return;
    }
    view_.overlay = overlay;
    emit changed(DocumentChange::View);
}

void Document::setWireframe(bool on) {
    changeView(&ViewState::wireframe, on);
}

void Document::setDesignerOutline(bool on) {
    changeView(&ViewState::designerOutline, on);
}

void Document::changeView(bool ViewState::*field, bool on) {
    if (view_.*field == on) {
        return;
    }
    view_.*field = on;
    emit changed(DocumentChange::View);
}

}  // namespace toile
