// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document.h"

#include <QString>
#include <utility>

namespace toile {

Document::Document(QObject* parent) : QObject(parent) {}

Document::~Document() = default;

int Document::pieceCount() const {
    return garment_ ? static_cast<int>(garment_->pieces.size()) : 0;
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
    garment_ = std::move(garment);
    scene_ = std::move(scene);
    results_.clear();
    selection_.clear();
    ++revision_;
    emit changed(DocumentChange::Garment | DocumentChange::Results | DocumentChange::Selection);
}

void Document::setResults(PieceResults results, std::shared_ptr<const Scene> scene) {
    Q_ASSERT(static_cast<int>(results.size()) == pieceCount());
    results_ = std::move(results);
    scene_ = std::move(scene);
    emit changed(DocumentChange::Results);
}

void Document::setOptions(const FlattenOptions& options) {
    if (options.method == options_.method && options.boundarySolver == options_.boundarySolver) {
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

void Document::setOverlay(Overlay overlay) {
    if (view_.overlay == overlay) {
        return;
    }
    view_.overlay = overlay;
    emit changed(DocumentChange::View);
}

void Document::setWireframe(bool on) {
    if (view_.wireframe == on) {
        return;
    }
    view_.wireframe = on;
    emit changed(DocumentChange::View);
}

}  // namespace toile
