// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/problems_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QShortcut>
#include <QStackedWidget>
#include <QStyle>
#include <QStyleOptionButton>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

#include "app/jobs/ready_checker.h"
#include "app/panels/problems_model.h"
#include "app/settings/length_display.h"
#include "app/widgets/cell_delegate.h"
#include "app/widgets/setting_fields.h"

namespace toile::app {

namespace {

/// Kinds with more rows than this start collapsed; they would push later kinds out of sight.
constexpr int kOpenUpTo = 4;

/// Paints a remedy as a button. The row comes from the click on the cell.
class HelpDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyleOptionViewItem empty(option);
        initStyleOption(&empty, index);
        empty.text.clear();
        const QWidget* list = option.widget;
        list->style()->drawControl(QStyle::CE_ItemViewItem, &empty, painter, list);
        if (index.data(ProblemsModel::RemedyRole).isValid()) {
            QStyleOptionButton button;
            button.initFrom(list);
            button.state = QStyle::State_Enabled | QStyle::State_Raised;
            button.rect = option.rect.adjusted(2, 1, -2, -1);
            button.text = index.data().toString();
            list->style()->drawControl(QStyle::CE_PushButton, &button, painter, list);
        }
    }

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        constexpr int kPadding = 24;
        return QStyledItemDelegate::sizeHint(option, index) + QSize(kPadding, 2);
    }
};

}  // namespace

struct ProblemsPanel::Outlook {
    std::set<int> open, closed;  ///< kinds
    QString key;                 ///< of the current row
    bool isSelected = false;     ///< whether the current row is selected
    int scroll = 0;
};

ProblemsPanel::ProblemsPanel(ReadyChecker& checker, QWidget* parent)
    : QWidget(parent),
      checker_(checker),
      model_(new ProblemsModel(this)),
      table_(new QTreeView(this)),
      mark_(new QLabel(this)),
      verdict_(makeHeading({}, this)),
      empty_(new QLabel(this)),
      pages_(new QStackedWidget(this)) {
    makeTable();
    empty_->setObjectName("problemsEmpty");
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setContentsMargins(24, 8, 24, 8);
    pages_->addWidget(table_);
    pages_->addWidget(empty_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(makeHead());
    layout->addWidget(pages_, 1);
    connect(&checker_, &ReadyChecker::changed, this, &ProblemsPanel::rebuild);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &ProblemsPanel::rebuild);
    rebuild();
}

QWidget* ProblemsPanel::makeHead() {
    auto* head = new QWidget(this);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(8, 3, 8, 3);
    row->setSpacing(6);
    mark_->setObjectName("verdictMark");
    verdict_->setObjectName("verdict");
    verdict_->setAccessibleName(tr("Ready to cut?"));
    row->addWidget(mark_);
    row->addWidget(verdict_, 1);
    constexpr const char* kNames[] = {"showFaults", "showDoubts", "showNotes"};
    const QString tips[] = {tr("List the errors to fix before cutting"),
                            tr("List the warnings to look at before cutting"),
                            tr("List the notes")};
    for (std::size_t i = 0; i < filters_.size(); ++i) {
        const Severity severity = kSeverities[i];
        auto* filter = new QToolButton(head);
        filter->setObjectName(kNames[i]);
        filter->setCheckable(true);
        filter->setChecked(true);
        filter->setAutoRaise(true);
        filter->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        filter->setIcon(severityMark(severity));
        filter->setToolTip(tips[i]);
        filter->setStatusTip(tips[i]);
        connect(filter, &QToolButton::toggled, this, [this, severity](bool on) {
            if (on) {
                shown_.insert(severity);
            } else {
                shown_.erase(severity);
            }
            rebuild();
        });
        row->addWidget(filter);
        filters_[i] = filter;
    }
    return head;
}

void ProblemsPanel::makeTable() {
    table_->setObjectName("problemTable");
    table_->setAccessibleName(tr("Problems"));
    table_->setModel(model_);
    dressList(*table_);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setExpandsOnDoubleClick(false);  // the first click already goes to the finding
    table_->header()->setMinimumSectionSize(80);
    table_->setItemDelegateForColumn(ProblemsModel::Help, new HelpDelegate(table_));
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(table_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
        index.column() == ProblemsModel::Help ? help(index) : goTo(index);
    });
    connect(table_, &QTreeView::customContextMenuRequested, this, &ProblemsPanel::showMenu);
    onEnter(*table_, [this] { goTo(table_->currentIndex()); });
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
        connect(new QShortcut(QKeySequence(QKeyCombination(Qt::ControlModifier, key)), table_, {},
                              {}, Qt::WidgetShortcut),
                &QShortcut::activated, this, [this] { help(table_->currentIndex()); });
    }
}

void ProblemsPanel::goTo(const QModelIndex& index) {
    const auto findings =
        index.siblingAtColumn(ProblemsModel::Where).data(ProblemsModel::FindingsRole);
    if (findings.isValid()) {
        emit wanted(findings.value<QList<int>>());
    }
}

void ProblemsPanel::help(const QModelIndex& index) {
    const QVariant remedy =
        index.siblingAtColumn(ProblemsModel::Help).data(ProblemsModel::RemedyRole);
    goTo(index);
    if (remedy.isValid()) {
        emit remedyWanted(static_cast<Remedy>(remedy.toInt()));
    }
}

void ProblemsPanel::showMenu(const QPoint& at) {
    const QModelIndex index = table_->indexAt(at).siblingAtColumn(ProblemsModel::Where);
    const auto findings = index.data(ProblemsModel::FindingsRole).value<QList<int>>();
    if (findings.isEmpty()) {
        return;
    }
    auto* menu = new QMenu(this);
    menu->setObjectName("problemMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    connect(menu->addAction(tr("Go to place")), &QAction::triggered, this,
            [this, findings] { emit wanted(findings); });
    const auto& finding = checker_.readiness().findings[static_cast<std::size_t>(findings.front())];
    for (const Remedy remedy : remediesFor(finding, checker_.plan())) {
        QAction* action = menu->addAction(remedyText(remedy));
        action->setToolTip(remedyTip(remedy));
        connect(action, &QAction::triggered, this, [this, findings, remedy] {
            emit wanted(findings);
            emit remedyWanted(remedy);
        });
    }
    menu->popup(table_->viewport()->mapToGlobal(at));
}

void ProblemsPanel::selectNothing() {
    table_->clearSelection();
}

int ProblemsPanel::count() const {
    const Readiness& readiness = checker_.readiness();
    return readiness.count(Severity::Fault) + readiness.count(Severity::Doubt);
}

void ProblemsPanel::rebuild() {
    const Outlook before = outlook();
    model_->show(checker_.readiness(), checker_.plan(), shown_);
    restore(before);
    fitColumns();
    updateHead();
    emit countChanged(count());
}

void ProblemsPanel::updateHead() {
    const Readiness& readiness = checker_.readiness();
    const bool isOpen = checker_.plan().garment != nullptr;
    const int size = style()->pixelMetric(QStyle::PM_SmallIconSize);
    mark_->setVisible(isOpen);
    mark_->setPixmap(verdictMark(readiness).pixmap(size, size));
    verdict_->setText(isOpen ? verdictLine(readiness) : QString());
    for (std::size_t i = 0; i < filters_.size(); ++i) {
        const int found = readiness.count(kSeverities[i]);
        filters_[i]->setText(severityCount(kSeverities[i], found));
        filters_[i]->setEnabled(found > 0);
    }
    empty_->setText(readiness.findings.empty()
                        ? tr("Ready to cut: seams match, no outline crosses itself, the strain is "
                             "within the fabric's limits, and every grain is set.")
                        : tr("All findings are hidden. Use the buttons above to show them."));
    pages_->setCurrentWidget(model_->rowCount() > 0 || !isOpen ? static_cast<QWidget*>(table_)
                                                               : empty_);
}

void ProblemsPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitColumns();
}

void ProblemsPanel::fitColumns() {
    constexpr int kAir = 12, kLongestWhere = 320;
    for (const int column : {ProblemsModel::Where, ProblemsModel::Problem, ProblemsModel::Help}) {
        table_->resizeColumnToContents(column);
        const int width = table_->columnWidth(column) + kAir;
        const int most = column == ProblemsModel::Where
                             ? kLongestWhere
                             : std::max(300, table_->viewport()->width() * 3 / 5);
        table_->setColumnWidth(column, std::min(width, most));
    }
}

ProblemsPanel::Outlook ProblemsPanel::outlook() const {
    Outlook seen;
    for (int row = 0; row < model_->rowCount(); ++row) {
        const QModelIndex index = model_->index(row, 0);
        const QVariant kind = index.data(ProblemsModel::KindRole);
        if (kind.isValid()) {
            (table_->isExpanded(index) ? seen.open : seen.closed).insert(kind.toInt());
        }
    }
    const QModelIndex current = table_->currentIndex().siblingAtColumn(ProblemsModel::Where);
    if (current.isValid()) {
        seen.key = current.data(ProblemsModel::KeyRole).toString();
        seen.isSelected = table_->selectionModel()->isSelected(current);
    }
    seen.scroll = table_->verticalScrollBar()->value();
    return seen;
}

void ProblemsPanel::restore(const Outlook& before) {
    const auto select = [this, &before](const QModelIndex& index) {
        if (!before.key.isEmpty() && index.data(ProblemsModel::KeyRole) == before.key) {
            table_->selectionModel()->setCurrentIndex(
                index, before.isSelected
                           ? QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows
                           : QItemSelectionModel::NoUpdate);
        }
    };
    for (int row = 0; row < model_->rowCount(); ++row) {
        const QModelIndex index = model_->index(row, 0);
        select(index);
        const QVariant kind = index.data(ProblemsModel::KindRole);
        if (!kind.isValid()) {
            continue;
        }
        const bool wasOpen = before.open.contains(kind.toInt());
        const bool isNew = !wasOpen && !before.closed.contains(kind.toInt());
        table_->setExpanded(index, wasOpen || (isNew && model_->rowCount(index) <= kOpenUpTo));
        for (int child = 0; child < model_->rowCount(index); ++child) {
            select(model_->index(child, 0, index));
        }
    }
    table_->verticalScrollBar()->setValue(before.scroll);
}

}  // namespace toile::app
