// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/cuts_panel.h"

#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScopedValueRollback>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>
#include <vector>

#include "app/document/document.h"
#include "app/settings/length_display.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "app/widgets/cell_delegate.h"
#include "app/widgets/setting_fields.h"

namespace toile::app {

namespace {

enum CutColumn { CutName, Author, PieceName, Length, CutColumnCount };

/// Item data roles of a row.
constexpr int kIsOwn = Qt::UserRole, kIsJoin = Qt::UserRole + 1, kCutId = Qt::UserRole + 2;

/// An invalid ID for a join.
CutId cutOf(const QTreeWidgetItem& row) {
    return {row.data(CutName, kCutId).toULongLong()};
}

bool isOf(const Seam& seam, CutId cut) {
    return std::ranges::find(seam.cuts, cut) != seam.cuts.end();
}

}  // namespace

CutsPanel::CutsPanel(const Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      count_(makeHeading({}, this)),
      table_(new QTreeWidget(this)) {
    count_->setContentsMargins(4, 3, 8, 3);
    table_->setObjectName("cutTable");
    table_->setAccessibleName(tr("Cuts"));
    table_->setRootIsDecorated(false);
    dressList(*table_);
    table_->setHeaderLabels({tr("Cut"), tr("Made by"), tr("Piece"), tr("Length")});
    table_->headerItem()->setTextAlignment(Length, Qt::AlignRight | Qt::AlignVCenter);
    table_->header()->setStretchLastSection(false);
    table_->header()->setSectionResizeMode(CutName, QHeaderView::Stretch);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(count_);
    layout->addWidget(table_, 1);
    table_->installEventFilter(this);
    auto* takeBack = new QAction(tr("&Remove"), table_);
    takeBack->setObjectName("takeCutBack");
    table_->addAction(takeBack);
    table_->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(takeBack, &QAction::triggered, this, &CutsPanel::removeCurrent);
    connect(table_, &QTreeWidget::itemSelectionChanged, this, &CutsPanel::tellSeam);
    connect(&document_, &Document::changed, this, &CutsPanel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &CutsPanel::rebuild);
    hide();
}

void CutsPanel::onChanged(const DocumentChange& what) {
    if (what.hasOtherPieces()) {
        rebuild();
    }
    if (what.touches(DocumentChange::Selection)) {
        selectInTable();
    }
}

void CutsPanel::selectInTable() {
    if (synchronizing_) {
        return;
    }
    const QScopedValueRollback guard(synchronizing_, true);
    table_->clearSelection();
    const std::optional<int> seam = document_.seam();
    for (int k = 0; seam && k < table_->topLevelItemCount(); ++k) {
        QTreeWidgetItem& row = *table_->topLevelItem(k);
        if (isOf(document_.garment()->seams.seams[static_cast<std::size_t>(*seam)], cutOf(row))) {
            table_->setCurrentItem(&row);
            return;
        }
    }
}

void CutsPanel::tellSeam() {
    const QList<QTreeWidgetItem*> rows = table_->selectedItems();
    if (synchronizing_ || rows.isEmpty()) {
        return;
    }
    const QScopedValueRollback guard(synchronizing_, true);
    const std::vector<Seam>& seams = document_.garment()->seams.seams;
    const auto seam = std::ranges::find_if(
        seams, [cut = cutOf(*rows.front())](const Seam& one) { return isOf(one, cut); });
    if (seam != seams.end()) {
        emit seamChosen(static_cast<int>(seam - seams.begin()));
    }
}

void CutsPanel::rebuild() {
    table_->clear();
    if (document_.garment()) {
        for (const AppliedCut& cut : document_.garment()->cuts) {
            auto* row = new QTreeWidgetItem(table_);
            row->setText(CutName, QString::fromStdString(cut.name));
            const bool own = cut.author == CutAuthor::User;
            const QString evidence = wordingText(cut.evidence);
            const QString named = evidence.isEmpty()
                                      ? row->text(CutName)
                                      : tr("%1: %2").arg(row->text(CutName), evidence);
            row->setToolTip(CutName, own ? tr("%1: press Delete to remove it").arg(named) : named);
            row->setData(CutName, kIsOwn, own);
            row->setData(CutName, kCutId, static_cast<qulonglong>(cut.id.value));
            row->setText(Author, !own                 ? tr("Toile")
                                 : evidence.isEmpty() ? tr("you")
                                                      : tr("you, as proposed"));
            row->setText(PieceName, QString::fromStdString(cut.piece));
            row->setText(Length, lengthWithUnit(cut.length));
            row->setTextAlignment(Length, Qt::AlignRight | Qt::AlignVCenter);
        }
        for (const AppliedJoin& join : document_.garment()->joins) {
            auto* row = new QTreeWidgetItem(table_);
            row->setText(CutName, QString::fromStdString(join.name));
            row->setToolTip(
                CutName,
                tr("%1 was joined: press Delete to restore the seam").arg(row->text(CutName)));
            row->setData(CutName, kIsOwn, true);
            row->setData(CutName, kIsJoin, true);
            row->setText(Author, tr("you, joined"));
            row->setText(PieceName, QString::fromStdString(join.piece));
            row->setText(Length, lengthWithUnit(join.length));
            row->setTextAlignment(Length, Qt::AlignRight | Qt::AlignVCenter);
        }
    }
    for (int column = Author; column < CutColumnCount; ++column) {
        table_->resizeColumnToContents(column);
    }
    const int all = table_->topLevelItemCount();
    const auto joins =
        document_.garment() ? static_cast<int>(document_.garment()->joins.size()) : 0;
    const int count = all - joins;
    QStringList counts;
    if (count > 0) {
        counts << (count == 1 ? tr("1 cut") : tr("%1 cuts").arg(count));
    }
    if (joins > 0) {
        counts << (joins == 1 ? tr("1 join") : tr("%1 joins").arg(joins));
    }
    count_->setText(counts.join(", "));
    setVisible(all > 0);
}

bool CutsPanel::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey =
        event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (!isKey || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Delete)) {
        return QWidget::eventFilter(watched, event);
    }
    // Accepting ShortcutOverride keeps Delete from the window's shortcut while the table has focus.
    event->accept();
    if (event->type() == QEvent::KeyPress) {
        removeCurrent();
    }
    return true;
}

void CutsPanel::removeCurrent() {
    const QTreeWidgetItem* row = table_->currentItem();
    if (row == nullptr || !row->data(CutName, kIsOwn).toBool()) {
        return;
    }
    if (row->data(CutName, kIsJoin).toBool()) {
        emit joinRemovalWanted(row->text(CutName).toStdString());
    } else {
        emit removeWanted(cutOf(*row));
    }
}

}  // namespace toile::app
