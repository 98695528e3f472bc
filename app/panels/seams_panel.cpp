// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/seams_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

#include "app/actions/action_registry.h"
#include "app/document/document.h"
#include "app/panels/cuts_panel.h"
#include "app/panels/seams_model.h"
#include "app/settings/length_display.h"
#include "app/widgets/cell_delegate.h"
#include "app/widgets/setting_fields.h"

namespace toile::app {

namespace {

/// Edits a percentage in a table cell. Without a stated value the editor starts empty and shows the
/// cell's value as a placeholder.
class EaseDelegate : public CellDelegate {
public:
    using CellDelegate::CellDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                          const QModelIndex& index) const override {
        auto* editor = new QLineEdit(parent);
        editor->setObjectName("easeEditor");
        editor->setFrame(false);
        editor->setAlignment(Qt::AlignRight);
        editor->setPlaceholderText(index.data(Qt::DisplayRole).toString());
        return editor;
    }

    /// Keeps text being typed when the figures change.
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        const auto* line = qobject_cast<const QLineEdit*>(editor);
        if (!line || !line->isModified()) {
            CellDelegate::setEditorData(editor, index);
        }
    }

    /// Ignores an untouched editor: the shown value is rounded.
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override {
        const auto* line = qobject_cast<const QLineEdit*>(editor);
        if (line && line->isModified()) {
            CellDelegate::setModelData(editor, model, index);
        }
    }
};

}  // namespace

/// Sorts the seams and hides free edges by default.
class SeamsPanel::Filter : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void showFree(bool shown) {
        showsFree_ = shown;
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        const QModelIndex index = sourceModel()->index(row, 0, parent);
        return showsFree_ || !index.data(SeamsModel::FreeRole).toBool();
    }

private:
    bool showsFree_ = false;
};

SeamsPanel::SeamsPanel(Document& document, const ActionRegistry& actions, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new SeamsModel(document, this)),
      sorted_(new Filter(this)),
      table_(new QTreeView(this)),
      summary_(makeHeading({}, this)),
      empty_(new QLabel(this)),
      free_(new QCheckBox(tr("Show free edges"), this)),
      pages_(new QStackedWidget(this)) {
    makeTable();
    empty_->setObjectName("seamsEmpty");
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setContentsMargins(24, 8, 24, 8);
    pages_->addWidget(table_);
    pages_->addWidget(empty_);

    auto* ledger = new QVBoxLayout;
    ledger->setSpacing(0);
    ledger->addWidget(makeHead(actions));
    ledger->addWidget(pages_, 1);
    auto* cuts = new CutsPanel(document, this);
    cuts->setMinimumWidth(300);
    cuts->setMaximumWidth(460);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addLayout(ledger, 3);
    layout->addWidget(cuts, 1);

    connect(cuts, &CutsPanel::seamChosen, &document_, &Document::setSeam);
    connect(cuts, &CutsPanel::removeWanted, this, &SeamsPanel::cutRemovalWanted);
    connect(cuts, &CutsPanel::joinRemovalWanted, this, &SeamsPanel::joinRemovalWanted);
    connect(model_, &SeamsModel::easeWanted, this, &SeamsPanel::easeWanted);
    connect(model_, &SeamsModel::drawingWanted, &document_, &Document::setEaseDrawn);
    // Connected after the model's own slot, so that its rows are new by then.
    connect(&document_, &Document::changed, this, &SeamsPanel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, [this] {
        updateHead();
        fitColumns();
    });
    updateHead();
}

QWidget* SeamsPanel::makeHead(const ActionRegistry& actions) {
    auto* head = new QWidget(this);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(8, 3, 8, 3);
    summary_->setObjectName("seamSummary");
    free_->setObjectName("showFreeEdges");
    free_->setToolTip(tr("Also list hems, openings and other edges that are not sewn"));
    connect(free_, &QCheckBox::toggled, this, &SeamsPanel::showFreeEdges);
    auto* walk = new QToolButton(head);
    walk->setObjectName("walkSeam");
    walk->setDefaultAction(&actions[ActionId::WalkSeam]);
    walk->setToolButtonStyle(Qt::ToolButtonTextOnly);
    row->addWidget(summary_, 1);
    row->addWidget(walk);
    row->addWidget(free_);
    return head;
}

void SeamsPanel::makeTable() {
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(SeamsModel::SortRole);
    table_->setObjectName("seamTable");
    table_->setAccessibleName(tr("Seams"));
    table_->setModel(sorted_);
    closeEditorsBeforeReset(*table_);
    table_->setRootIsDecorated(false);
    dressList(*table_);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    table_->setItemDelegateForColumn(SeamsModel::Ease, new EaseDelegate(table_));
    table_->setSortingEnabled(true);
    table_->sortByColumn(SeamsModel::Error, Qt::DescendingOrder);  // the worst first
    table_->header()->setMinimumSectionSize(48);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &SeamsPanel::selectInDocument);
    connect(table_, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
        if (!(index.flags() & Qt::ItemIsEditable)) {
            emit activated();
        }
    });
    onEnter(*table_, [this] { emit activated(); });
}

void SeamsPanel::onChanged(const DocumentChange& what) {
    if (what.touches(&Derived::garment, &Derived::results, &Derived::pattern,
                     &DocumentState::labels)) {
        updateHead();
        fitColumns();
    }
    if (what.touches(DocumentChange::Selection)) {
        selectInTable();
    }
}

void SeamsPanel::showFreeEdges(bool shown) {
    sorted_->showFree(shown);
    updateHead();
    fitColumns();
}

void SeamsPanel::updateHead() {
    const QString summary = model_->summary();
    summary_->setText(summary.isEmpty() ? tr("No seams") : summary);
    empty_->setText(
        tr("No edges of this garment meet, so nothing is sewn. Use “Show free edges” to list the "
           "edges."));
    pages_->setCurrentWidget(sorted_->rowCount() > 0 ? static_cast<QWidget*>(table_) : empty_);
}

void SeamsPanel::fitColumns() {
    constexpr int kAir = 4, kLongestName = 380;
    // The last column takes the spare width, so that figures stay next to their names.
    for (int column = 0; column < SeamsModel::Fit; ++column) {
        table_->resizeColumnToContents(column);
        const int width = table_->columnWidth(column) + kAir;
        table_->setColumnWidth(column,
                               column == SeamsModel::Name ? std::min(width, kLongestName) : width);
    }
}

void SeamsPanel::selectInTable() {
    if (synchronizing_) {
        return;
    }
    const QScopedValueRollback guard(synchronizing_, true);
    QModelIndex index;
    if (const std::optional<int> seam = document_.seam()) {
        index = sorted_->mapFromSource(model_->index(*seam, SeamsModel::Name));
    }
    if (!index.isValid()) {
        table_->selectionModel()->clearSelection();
        return;
    }
    QItemSelectionModel& selection = *table_->selectionModel();
    if (table_->currentIndex().row() == index.row() && selection.isRowSelected(index.row())) {
        return;  // changing the current cell would close its editor
    }
    selection.setCurrentIndex(index,
                              QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    table_->scrollTo(index);
}

void SeamsPanel::selectInDocument() {
    if (synchronizing_) {
        return;
    }
    const QScopedValueRollback guard(synchronizing_, true);
    const QModelIndexList rows = table_->selectionModel()->selectedRows();
    document_.setSeam(rows.isEmpty() ? std::optional<int>()
                                     : sorted_->mapToSource(rows.front()).row());
}

void SeamsPanel::editEase() {
    if (!document_.seam()) {
        return;
    }
    table_->setFocus();  // commits an open editor, which may reorder rows
    if (const std::optional<int> seam = document_.seam()) {
        const QPersistentModelIndex cell =
            sorted_->mapFromSource(model_->index(*seam, SeamsModel::Ease));
        table_->setCurrentIndex(cell);
        if (cell.flags() & Qt::ItemIsEditable && !table_->isPersistentEditorOpen(cell)) {
            table_->edit(cell);
        }
    }
}

}  // namespace toile::app
