// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/mirrored_pieces_list.h"

#include <QHeaderView>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <algorithm>

#include "app/document/document.h"
#include "app/text/figures.h"
#include "app/widgets/cell_delegate.h"
#include "core/project/piece_settings.h"

namespace toile::app {

namespace {

using Drawing = MirroredPieces::Drawing;

Qt::CheckState halfOf(const MirroredPieces& row, const std::vector<PieceSettings>& settings) {
    const auto isHalved = [&settings](int piece) {
        return settings[static_cast<std::size_t>(piece)].byHalf;
    };
    const std::vector<int> pieces = row.pieces();
    return std::ranges::all_of(pieces, isHalved)   ? Qt::Checked
           : std::ranges::any_of(pieces, isHalved) ? Qt::PartiallyChecked
                                                   : Qt::Unchecked;
}

}  // namespace

MirroredPiecesList::MirroredPiecesList(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("mirroredPieceList");
    setAccessibleName(tr("Mirrored pieces"));
    setRootIsDecorated(false);
    dressList(*this);
    setColumnCount(ColumnCount);
    setHeaderLabels({tr("Pieces"), tr("Differ by"), tr("Drawn"), tr("Half only")});
    headerItem()->setToolTip(Name, tr("Two pieces that mirror each other, or one symmetric piece"));
    headerItem()->setToolTip(
        Deviation, tr("Root mean square distance between a piece and the other's mirror image"));
    headerItem()->setToolTip(Drawn, tr("How the pattern draws the pieces"));
    headerItem()->setToolTip(
        Half, tr("Draw only one piece of a pair, or one half of a piece to cut on the fold"));
    headerItem()->setTextAlignment(Deviation, Qt::AlignRight | Qt::AlignVCenter);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    for (const Column column : {Deviation, Drawn, Half}) {
        header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (!fills_ && column == Half) {
            emit halfWanted(indexOfTopLevelItem(item), item->checkState(Half) == Qt::Checked);
        }
    });
    const auto choose = [this](QTreeWidgetItem* item) {
        if (!fills_ && item) {
            emit rowChosen(indexOfTopLevelItem(item));
        }
    };
    connect(this, &QTreeWidget::currentItemChanged, this, choose);
    connect(this, &QTreeWidget::itemClicked, this, choose);  // a click on the current row, too
}

void MirroredPiecesList::show(const Document& document, const SymmetryFacts& facts) {
    const QScopedValueRollback fills(fills_, true);
    const int place = verticalScrollBar()->value();
    rows_ = facts.rows;
    // Reuse rows, so that a click that changes one does not delete it under the pointer.
    while (topLevelItemCount() > static_cast<int>(rows_.size())) {
        delete takeTopLevelItem(topLevelItemCount() - 1);
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        auto* item = topLevelItem(static_cast<int>(k));
        fill(item ? *item : *new QTreeWidgetItem(this), document, rows_[k]);
    }
    verticalScrollBar()->setValue(place);
}

void MirroredPiecesList::fill(QTreeWidgetItem& item, const Document& document,
                              const MirroredPieces& row) {
    QStringList names;
    for (const int piece : row.pieces()) {
        names << pieceName(document, piece);
    }
    item.setText(Name, names.join(" / "));
    item.setToolTip(Name, row.isPair()
                              ? tr("%1 and %2 mirror each other").arg(names.front(), names.back())
                          : row.counterpart >= 0 ? tr("%1 is symmetric").arg(names.front())
                                                 : names.front());
    item.setText(Deviation,
                 row.counterpart < 0 ? QString(QChar(0x2013)) : lengthWithUnit(row.deviation));
    item.setTextAlignment(Deviation, Qt::AlignRight | Qt::AlignVCenter);
    const Words words = drawnWords(document, row);
    item.setText(Drawn, words.word);
    item.setToolTip(Drawn, words.tip);
    const Qt::CheckState half = halfOf(row, document.settings());
    const bool canBeHalved = row.drawing == Drawing::Equal || half != Qt::Unchecked;
    item.setData(Half, Qt::CheckStateRole, canBeHalved ? QVariant(half) : QVariant());
    item.setText(Half, !canBeHalved   ? QString()
                       : row.isPair() ? tr("cut 1 pair")
                                      : tr("cut on the fold"));
    item.setToolTip(Half,
                    canBeHalved ? QString() : tr("Only pieces that are drawn equal can be halved"));
}

MirroredPiecesList::Words MirroredPiecesList::drawnWords(const Document& document,
                                                         const MirroredPieces& row) {
    if (row.counterpart < 0) {
        return {tr("no counterpart"),
                tr("No other piece mirrors this one, and it is not symmetric")};
    }
    switch (row.drawing) {
        case Drawing::Equal:
            return {tr("equal"), equalTip(document, row)};
        case Drawing::Kept:
            return {tr("as in the file"), tr("%1 and %2 differ by %3, more than the tolerance of "
                                             "%4, so both keep their shapes")
                                              .arg(seamName(document, row.unequal->seam),
                                                   seamName(document, row.unequal->mirrored),
                                                   lengthWithUnit(row.unequal->difference),
                                                   lengthWithUnit(row.unequal->tolerance))};
        case Drawing::OtherOutline:
            return {tr("other segments"), tr("The segments of the two outlines are in a different "
                                             "order, so each keeps its line")};
        case Drawing::NotFlat:
            return {tr("not flat"), tr("Only flat pieces are drawn")};
        case Drawing::NotDrawn:
            return {tr("not drawn"), tr("No common line was found, so each keeps its own")};
    }
    return {};
}

QString MirroredPiecesList::equalTip(const Document& document, const MirroredPieces& row) {
    if (!row.isPair()) {
        return tr("One half of the line is the mirror image of the other");
    }
    const auto& lead = document.garment()->pieces[static_cast<std::size_t>(row.lead)];
    return document.state().lines.mirror == Mirror::First
               ? tr("Both use the line of %1").arg(QString::fromStdString(lead->name))
               : tr("Both use the mean of their lines");
}

void MirroredPiecesList::select(const std::set<int>& pieces) {
    const auto holdsAll = [&pieces](const MirroredPieces& row) {
        return !pieces.empty() && std::ranges::all_of(pieces, [&row](int piece) {
            return piece == row.piece || piece == row.counterpart;
        });
    };
    const auto found = std::ranges::find_if(rows_, holdsAll);
    const QScopedValueRollback fills(fills_, true);
    if (found == rows_.end()) {
        setCurrentItem(nullptr);
        clearSelection();
    } else {
        setCurrentItem(topLevelItem(static_cast<int>(found - rows_.begin())));
    }
}

}  // namespace toile::app
