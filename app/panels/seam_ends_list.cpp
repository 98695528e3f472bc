// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/seam_ends_list.h"

#include <QHeaderView>
#include <QScopedValueRollback>
#include <QScrollBar>

#include "app/document/document.h"
#include "app/text/figures.h"
#include "app/widgets/cell_delegate.h"

namespace toile::app {

namespace {

constexpr int kSeamOfRow = Qt::UserRole;

}  // namespace

SeamEndsList::SeamEndsList(QWidget* parent) : QTreeWidget(parent) {
    setObjectName("seamEndList");
    setAccessibleName(tr("Seam ends"));
    setRootIsDecorated(false);
    dressList(*this);
    setTextElideMode(Qt::ElideMiddle);  // seam names start alike: "panel 1 / panel 12"
    setColumnCount(ColumnCount);
    setHeaderLabels({tr("Seam end"), tr("At"), tr("Kink"), tr("Drawn")});
    headerItem()->setToolTip(Name, tr("Select to remove the kink at this seam end"));
    headerItem()->setToolTip(End, tr("Start or end of the seam"));
    headerItem()->setToolTip(Kink, tr("Kink between the two lines at the seam end, as flattened"));
    headerItem()->setToolTip(Kept, tr("Remaining kink in the drawn pattern"));
    for (const Column column : {Kink, Kept}) {
        headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    for (const Column column : {End, Kink, Kept}) {
        header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* row, int column) {
        if (!fills_ && column == Name) {
            emit trueingWanted(indexOfTopLevelItem(row), row->checkState(Name) == Qt::Checked);
        }
    });
    const auto choose = [this](const QTreeWidgetItem* row) {
        if (!fills_ && row) {
            emit seamChosen(row->data(Name, kSeamOfRow).toInt());
        }
    };
    connect(this, &QTreeWidget::currentItemChanged, this, choose);
    connect(this, &QTreeWidget::itemClicked, this, choose);  // a click on the current row, too
}

void SeamEndsList::show(const Document& document, const LineFacts& facts) {
    const QScopedValueRollback fills(fills_, true);
    const int place = verticalScrollBar()->value();
    // Reuse rows, so that a click that changes one does not delete it under the pointer.
    while (topLevelItemCount() > static_cast<int>(facts.ends.size())) {
        delete takeTopLevelItem(topLevelItemCount() - 1);
    }
    for (std::size_t k = 0; k < facts.ends.size(); ++k) {
        const SeamEnd& end = facts.ends[k];
        auto* row = topLevelItem(static_cast<int>(k));
        row = row ? row : new QTreeWidgetItem(this);
        row->setText(Name, seamName(document, end.seam));
        row->setToolTip(Name, row->text(Name));
        row->setCheckState(Name, end.isTrued ? Qt::Checked : Qt::Unchecked);
        row->setData(Name, kSeamOfRow, end.seam);
        row->setText(End, end.atEnd ? tr("end") : tr("start"));
        row->setText(Kink, angleWithUnit(end.kink));
        row->setText(Kept, angleWithUnit(facts.kept[k]));
        for (const Column column : {Kink, Kept}) {
            row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        }
    }
    verticalScrollBar()->setValue(place);
}

void SeamEndsList::select(std::optional<int> seam) {
    const QTreeWidgetItem* current = currentItem();
    if (seam && current && current->data(Name, kSeamOfRow).toInt() == *seam &&
        current->isSelected()) {
        return;
    }
    const QScopedValueRollback fills(fills_, true);
    QTreeWidgetItem* found = nullptr;
    for (int k = 0; seam && !found && k < topLevelItemCount(); ++k) {
        found =
            topLevelItem(k)->data(Name, kSeamOfRow).toInt() == *seam ? topLevelItem(k) : nullptr;
    }
    if (found) {
        setCurrentItem(found);
    } else {
        setCurrentItem(nullptr);
        clearSelection();
    }
}

}  // namespace toile::app
