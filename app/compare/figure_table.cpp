// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/compare/figure_table.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLocale>
#include <algorithm>

#include "app/base/text.h"
#include "app/text/figures.h"

namespace toile::app {

namespace {

constexpr double kMillisecond = 1e-3;
constexpr QChar kDash(0x2013), kStar(0x2605);
/// Above and below a row's letters.
constexpr int kRowAir = 9;

/// From what a person asks first to what only we ask.
constexpr Criterion kRows[] = {
    Criterion::StrainMean,   Criterion::StrainMax,        Criterion::StrainMin,
    Criterion::SeamMismatch, Criterion::LengthError,      Criterion::PiA,
    Criterion::ReferenceRms, Criterion::FlippedTriangles, Criterion::OutlineCrossings,
    Criterion::Seconds,
};

/// Without the unit.
QString figureText(FigureFormat format, double value) {
    switch (format) {
        case FigureFormat::Seconds:
            value /= kMillisecond;
            return QLocale().toString(value, 'f', value < 100 ? 1 : 0);
        case FigureFormat::Ratio:
            return percent(value);
        case FigureFormat::SignedRatio:
            return signedPercent(value);
        case FigureFormat::LengthError:
            return boundaryError(value);
        case FigureFormat::Count:
            return QLocale().toString(static_cast<int>(value));
        case FigureFormat::Millimetres:
            return fineLength(value);
    }
    return {};
}

/// Per method: whether its figure is the best one, or reads like it. None is where all read alike.
std::vector<bool> bestOnes(Criterion criterion, const std::vector<std::optional<double>>& values,
                           const QStringList& texts) {
    const auto best = bestOf(criterion, values);
    const QString text = best ? texts[static_cast<qsizetype>(*best)] : QString();
    const auto isOther = [&](const QString& other) { return !other.isEmpty() && other != text; };
    const bool isAny = best && std::ranges::any_of(texts, isOther);
    std::vector<bool> marks;
    for (const QString& each : texts) {
        marks.push_back(isAny && each == text);
    }
    return marks;
}

}  // namespace

FigureTable::FigureTable(QWidget* parent) : QTableWidget(parent) {
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

void FigureTable::setEntries(const std::vector<MethodComparison::Entry>& entries) {
    std::vector<Criterion> rows(std::begin(kRows), std::end(kRows));
    const bool hasReference = std::ranges::any_of(entries, [](const auto& entry) -> bool {
        return entry.made.figures[Criterion::ReferenceRms].has_value();
    });
    if (!hasReference) {
        std::erase(rows, Criterion::ReferenceRms);
    }
    // Not cleared first: that would take a reader's place in the table away.
    setRowCount(static_cast<int>(rows.size()));
    setColumnCount(static_cast<int>(entries.size()));
    for (int column = 0; column < columnCount(); ++column) {
        const Method method = entries[static_cast<std::size_t>(column)].method;
        setHorizontalHeaderItem(column, new QTableWidgetItem(methodName(method)));
    }
    for (int row = 0; row < rowCount(); ++row) {
        setRow(row, traits(rows[static_cast<std::size_t>(row)]), entries);
    }
    updateGeometry();
}

void FigureTable::setRow(int row, const CriterionTraits& criterion,
                         const std::vector<MethodComparison::Entry>& entries) {
    const QString tip = app::tr(criterion.tip);
    auto* title = new QTableWidgetItem(app::tr(criterion.title).replace("%1", lengthUnit()));
    title->setToolTip(tip);
    title->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    setVerticalHeaderItem(row, title);

    std::vector<std::optional<double>> values;
    QStringList texts;
    for (const MethodComparison::Entry& entry : entries) {
        const bool isDone = entry.stage == MethodComparison::Stage::Done;
        const auto& value =
            values.emplace_back(isDone ? entry.made.figures[criterion.criterion] : std::nullopt);
        texts << (value    ? figureText(criterion.format, *value)
                  : isDone ? QString(kDash)
                           : QString());
    }
    const std::vector<bool> best = bestOnes(criterion.criterion, values, texts);
    for (int column = 0; column < columnCount(); ++column) {
        const QString& text = texts[column];
        const bool isBest = best[static_cast<std::size_t>(column)];
        auto* cell = new QTableWidgetItem(isBest ? QString("%1 %2").arg(kStar).arg(text) : text);
        cell->setData(PlainRole, text);
        cell->setData(Qt::AccessibleTextRole, isBest ? tr("%1, the best").arg(text) : text);
        cell->setToolTip(tip);
        cell->setTextAlignment(Qt::AlignCenter);
        cell->setFlags(Qt::ItemIsSelectable | Qt::ItemIsEnabled);
        if (isBest) {
            QFont bold;
            bold.setBold(true);
            cell->setFont(bold);
        }
        setItem(row, column, cell);
    }
}

void FigureTable::setTitleWidth(int pixels) {
    verticalHeader()->setFixedWidth(pixels);
    updateGeometries();
}

QString FigureTable::copiedText() const {
    const bool all = selectionModel()->selectedRows().isEmpty();
    QStringList lines, cells{QString()};
    for (int column = 0; column < columnCount(); ++column) {
        cells << horizontalHeaderItem(column)->text();
    }
    lines << cells.join('\t');
    for (int row = 0; row < rowCount(); ++row) {
        if (!all && !selectionModel()->isRowSelected(row, {})) {
            continue;
        }
        cells = {verticalHeaderItem(row)->text()};
        for (int column = 0; column < columnCount(); ++column) {
            cells << item(row, column)->data(PlainRole).toString();
        }
        lines << cells.join('\t');
    }
    return lines.join('\n') + '\n';
}

QSize FigureTable::sizeHint() const {
    return {QTableWidget::sizeHint().width(), verticalHeader()->length() + 2 * frameWidth()};
}

QSize FigureTable::minimumSizeHint() const {
    return {320, sizeHint().height()};
}

}  // namespace toile::app
