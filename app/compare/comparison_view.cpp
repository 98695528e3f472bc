// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/comparison_view.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>

namespace toile {

namespace {

/// Above and below a row's letters.
constexpr int kRowAir = 9;

}  // namespace

ComparisonView::ComparisonView(QWidget* parent) : QTableView(parent) {
    setObjectName("compareTable");
    setAccessibleName(tr("Figures of the methods"));
    setFrameShape(QFrame::NoFrame);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setTabKeyNavigation(false);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    horizontalHeader()->hide();  // the names stand over the pictures
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setMinimumSectionSize(20);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowAir);
    verticalHeader()->setSectionsClickable(false);
    verticalHeader()->setHighlightSections(false);
    verticalHeader()->setStyleSheet(
        "QHeaderView, QHeaderView::section { border: none; background: transparent; }");
    verticalHeader()->viewport()->setAutoFillBackground(false);

    auto* copy = new QAction(tr("&Copy"), this);
    copy->setObjectName("copyComparison");
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copy, &QAction::triggered, this,
            [this] { QGuiApplication::clipboard()->setText(copiedText()); });
    addAction(copy);
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

void ComparisonView::setModel(QAbstractItemModel* model) {
    QTableView::setModel(model);
    connect(model, &QAbstractItemModel::modelReset, this, &QWidget::updateGeometry);
}

void ComparisonView::setTitleWidth(int pixels) {
    verticalHeader()->setFixedWidth(pixels);
    updateGeometries();
}

QString ComparisonView::copiedText() const {
    const QAbstractItemModel& figures = *model();
    const bool all = selectionModel()->selectedRows().isEmpty();
    QStringList lines, cells{QString()};
    for (int column = 0; column < figures.columnCount(); ++column) {
        cells << figures.headerData(column, Qt::Horizontal).toString();
    }
    lines << cells.join('\t');
    for (int row = 0; row < figures.rowCount(); ++row) {
        if (!all && !selectionModel()->isRowSelected(row, {})) {
            continue;
        }
        cells = {figures.headerData(row, Qt::Vertical).toString()};
        for (int column = 0; column < figures.columnCount(); ++column) {
            cells << figures.index(row, column).data(Qt::EditRole).toString();
        }
        lines << cells.join('\t');
    }
    return lines.join('\n') + '\n';
}

QSize ComparisonView::sizeHint() const {
    return {QTableView::sizeHint().width(), verticalHeader()->length() + 2 * frameWidth()};
}

QSize ComparisonView::minimumSizeHint() const {
    return {320, sizeHint().height()};
}

}  // namespace toile
