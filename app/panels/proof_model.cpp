// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/proof_model.h"

#include <QLocale>
#include <utility>

#include "app/document/document.h"
#include "app/document/shown_proof.h"
#include "app/text/figures.h"

namespace toile::app {

namespace {

QString onePercent(double part, int decimals) {
    return QLocale().toString(100 * part, 'f', decimals);
}

}  // namespace

ProofModel::ProofModel(const Document& document, QObject* parent)
    : ColumnsModel(ColumnCount, parent), document_(document) {}

void ProofModel::show(std::shared_ptr<const ShownProof> shown) {
    beginResetModel();
    shown_ = std::move(shown);
    pieces_.clear();
    if (shown_) {
        for (std::size_t k = 0; k < shown_->proof->pieces.size(); ++k) {
            if (shown_->proof->pieces[k].isSewn()) {
                pieces_.push_back(static_cast<int>(k));
            }
        }
    }
    setRows(static_cast<int>(pieces_.size()));
    endResetModel();
}

std::vector<ColumnsModel::Heading> ProofModel::headings() const {
    const QString unit = lengthUnit();
    return {{tr("Piece"), tr("Piece of the garment; click to go to its largest gap")},
            {tr("Gap (%1)").arg(unit), tr("Mean distance from the design")},
            {tr("95 % (%1)").arg(unit), tr("Gap that 95 % of its area does not exceed")},
            {tr("Largest (%1)").arg(unit), tr("Largest gap")},
            {tr("Pulls (%)"), tr("Stretch that 95 % of its area does not exceed")},
            {tr("Slack (%)"), tr("Surplus that 95 % of its area does not exceed")},
            {tr("Hangs free (%)"), tr("Share of its area that touches nothing")}};
}

ColumnsModel::Cell ProofModel::cell(int row, int column) const {
    const int piece = pieces_[static_cast<std::size_t>(row)];
    const auto at = static_cast<std::size_t>(piece);
    const ProvenPiece& proven = shown_->proof->pieces[at];
    const auto length = [](double millimetres) -> Cell {
        return {fineLength(millimetres), millimetres};
    };
    const auto share = [](double part, int decimals) -> Cell {
        return {onePercent(part, decimals), part};
    };
    switch (column) {
        case Name: {
            const bool isHere = shown_->ground.garment == document_.garment();
            const QString name =
                isHere ? pieceName(document_, piece)
                       : QString::fromStdString(shown_->ground.garment->pieces[at]->name);
            return {name};
        }
        case Mean:
            return length(proven.gapFigures.mean);
        case Most:
            return length(proven.gapFigures.most95);
        case Largest:
            return length(proven.gapFigures.max);
        case Pull:
            return share(proven.mostPull, 1);
        case Slack:
            return share(proven.mostSlack, 1);
        case Free:
            return share(proven.freeShare, 0);
        default:
            return {};
    }
}

QVariant ProofModel::data(const QModelIndex& index, int role) const {
    return role == PieceRole ? QVariant(pieces_[static_cast<std::size_t>(index.row())])
                             : ColumnsModel::data(index, role);
}

}  // namespace toile::app
