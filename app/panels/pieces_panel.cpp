// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pieces_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelection>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QSortFilterProxyModel>
#include <QSpinBox>
#include <QTreeView>
#include <algorithm>
#include <numeric>
#include <utility>

#include "app/document/document.h"
#include "app/document/piece_edits.h"
#include "app/panels/pieces_model.h"
#include "app/settings/length_display.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "app/widgets/cell_delegate.h"
#include "app/widgets/columns_model.h"
#include "core/project/piece_settings.h"
#include "core/seam/seam_measure.h"

namespace toile::app {
namespace {

/// Edits the quantity of a piece in a table cell.
class QuantityDelegate : public CellDelegate {
public:
    using CellDelegate::CellDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                          const QModelIndex&) const override {
        auto* editor = new QSpinBox(parent);
        editor->setObjectName("quantityEditor");
        editor->setFrame(false);
        editor->setAlignment(Qt::AlignRight);
        editor->setRange(1, kMaxCopies);
        return editor;
    }

    /// Ignores an untouched editor, so that other selected pieces keep their quantities.
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override {
        const auto* box = qobject_cast<const QSpinBox*>(editor);
        const auto* line = box ? box->findChild<const QLineEdit*>() : nullptr;
        if ((line && line->isModified()) ||
            (box && box->value() != index.data(Qt::EditRole).toInt())) {
            CellDelegate::setModelData(editor, model, index);
        }
    }
};

/// Check box of a mirrored pair, with an outline that is visible on dark rows too.
class PairDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        // Styles draw the outline in the window's colour, which is close to the rows' colour.
        option->palette.setColor(QPalette::Window,
                                 option->palette.color(QPalette::PlaceholderText));
    }
};

constexpr int kMeasuredRows = 60;  ///< rows around the visible ones that set column widths

QString row(const QString& name, const QString& value) {
    return QString(
               "<tr><td style='padding-right:12px'>%1</td><td "
               "align='right' style='white-space:nowrap'>%2</td></tr>")
        .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
}

}  // namespace

PiecesView::PiecesView(QWidget* parent) : QTreeView(parent) {
    setEditTriggers(DoubleClicked | EditKeyPressed);
    setItemDelegate(new CellDelegate(this));
    setItemDelegateForColumn(PiecesModel::Quantity, new QuantityDelegate(this));
    setItemDelegateForColumn(PiecesModel::Pair, new PairDelegate(this));
}

void PiecesView::openEditor(const QModelIndex& cell) {
    setFocus();  // commits and closes an open editor
    edit(cell, AllEditTriggers, nullptr);
}

bool PiecesView::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
    const bool isKey = event && event->type() == QEvent::KeyPress;
    if (trigger == EditKeyPressed) {
        return QTreeView::edit(index.siblingAtColumn(PiecesModel::Name), trigger, event);
    }
    if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        return QTreeView::edit(index.siblingAtColumn(PiecesModel::Pair), trigger, event);
    }
    return QTreeView::edit(index, trigger, event);
}

QItemSelectionModel::SelectionFlags PiecesView::selectionCommand(const QModelIndex& index,
                                                                 const QEvent* event) const {
    const bool changes = index.column() != PiecesModel::Name &&  // a name is for one piece
                         index.flags() & (Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
    if (changes && event && selectionModel()->isSelected(index) &&
        (event->type() == QEvent::MouseButtonPress ||
         event->type() == QEvent::MouseButtonRelease) &&
        static_cast<const QMouseEvent*>(event)->modifiers() == Qt::NoModifier) {
        return QItemSelectionModel::NoUpdate;
    }
    return QTreeView::selectionCommand(index, event);
}

PiecesPanel::PiecesPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new PiecesModel(document, this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new PiecesView(this)),
      columns_(
          new ColumnChooser(*table_->header(),
                            {"name", "status", "quantity", "pair", "material", "layer", "method",
                             "triangles", "area", "outline", "outlineError", "strainMean",
                             "strainRange", "flips", "crossings", "referenceRms", "referenceMax"},
                            this)),
      details_(new QLabel(this)) {
    makeTable();
    details_->setObjectName("pieceDetails");
    details_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    details_->setWordWrap(true);
    details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    details_->setContentsMargins(14, 8, 14, 8);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(details_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setMinimumWidth(290);
    scroll->setMaximumWidth(330);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(table_, 4);
    layout->addWidget(scroll, 1);
    // Connected after the model's own slot, so that its rows are new by then.
    connect(&document_, &Document::changed, this, &PiecesPanel::onChanged);
    connect(columns_, &ColumnChooser::changed, this, &PiecesPanel::fitColumns);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, [this] {
        fitColumns();
        updateDetails();
    });
    fitColumns();
    updateDetails();
}

void PiecesPanel::makeTable() {
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(PiecesModel::SortRole);
    table_->setObjectName("pieceTable");
    table_->setAccessibleName(tr("Pieces"));
    table_->setModel(sorted_);
    closeEditorsBeforeReset(*table_);
    table_->setRootIsDecorated(false);
    dressList(*table_);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setSortingEnabled(true);
    table_->sortByColumn(-1, Qt::AscendingOrder);  // in the garment's order by default
    table_->header()->setStretchLastSection(false);
    table_->header()->setMinimumSectionSize(46);
    table_->header()->setResizeContentsPrecision(kMeasuredRows);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &PiecesPanel::selectInDocument);
    connect(table_, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
        if (!(index.flags() & (Qt::ItemIsEditable | Qt::ItemIsUserCheckable))) {
            emit activated();
        }
    });
    connect(model_, &PiecesModel::nameWanted, this,
            [this](int piece, const QString& name) { renamePiece(document_, piece, name); });
    connect(model_, &PiecesModel::quantityWanted, this, [this](int piece, int quantity) {
        setQuantity(document_, meantWith(piece), quantity);
    });
    connect(model_, &PiecesModel::pairWanted, this, [this](int piece, bool isPair) {
        setMirroredPair(document_, meantWith(piece), isPair);
    });
    onEnter(*table_, [this] { emit activated(); });
}

void PiecesPanel::onChanged(const DocumentChange& what) {
    if (what.touches(&Derived::garment, &Derived::results, &DocumentState::labels,
                     &DocumentState::reference, DocumentChange::ReferenceMatch) ||
        (what.touches(&DocumentState::settings) &&
         table_->isColumnHidden(PiecesModel::MaterialName) == model_->hasMaterials())) {
        fitColumns();
    }
    if (what.touches(DocumentChange::Selection)) {
        selectInTable();
    }
    updateDetails();
}

QTreeView& PiecesPanel::table() {
    return *table_;
}

std::vector<int> PiecesPanel::meantWith(int piece) const {
    const auto& selection = document_.selection();
    return document_.isSelected(piece) ? std::vector<int>(selection.begin(), selection.end())
                                       : std::vector<int>{piece};
}

void PiecesPanel::editName() {
    if (document_.selection().size() == 1) {
        editCell(*document_.selection().begin(), PiecesModel::Name);
    }
}

void PiecesPanel::editQuantity() {
    if (!document_.selection().empty()) {
        editCell(*document_.selection().begin(), PiecesModel::Quantity);
    }
}

void PiecesPanel::editCell(int piece, int column) {
    const QModelIndex cell = sorted_->mapFromSource(model_->index(piece, column));
    table_->scrollTo(cell);
    table_->selectionModel()->setCurrentIndex(cell, QItemSelectionModel::NoUpdate);
    table_->openEditor(cell);
}

QStringList PiecesPanel::quietColumns() const {
    QStringList quiet{"triangles", "outlineError"};
    for (const auto& [column, name] :
         {std::pair(PiecesModel::Method, "method"), std::pair(PiecesModel::Flips, "flips"),
          std::pair(PiecesModel::Crossings, "crossings")}) {
        if (!model_->isTelling(column)) {
            quiet << name;
        }
    }
    return quiet;
}

void PiecesPanel::fitColumns() {
    constexpr int kCellAir = 6;
    const bool hasReference = model_->hasReference(), hasMaterials = model_->hasMaterials();
    columns_->propose(quietColumns());
    wanted_.assign(PiecesModel::ColumnCount, 0);
    for (int column = 0; column < PiecesModel::ColumnCount; ++column) {
        table_->setColumnHidden(column,
                                columns_->isHidden(column) ||
                                    (PiecesModel::isAboutReference(column) && !hasReference) ||
                                    (column == PiecesModel::MaterialName && !hasMaterials) ||
                                    (column == PiecesModel::Layer && !model_->hasLayers()));
        if (table_->isColumnHidden(column)) {
            continue;
        }
        table_->resizeColumnToContents(column);
        wanted_[static_cast<std::size_t>(column)] = table_->columnWidth(column) + kCellAir;
    }
    fillWidth();
}

void PiecesPanel::fillWidth() {
    std::vector<int> widths = wanted_;
    if (widths.empty()) {
        return;
    }
    int spare = table_->viewport()->width() - std::accumulate(widths.begin(), widths.end(), 0);
    const int least = table_->header()->minimumSectionSize();
    while (spare < 0) {  // shorten the widest columns, which loses least text
        const auto widest = std::max_element(widths.begin(), widths.end());
        if (*widest <= least) {
            break;
        }
        const int cut = std::min({-spare, *widest - least, 8});
        *widest -= cut;
        spare += cut;
    }
    for (int column = 0; column < PiecesModel::ColumnCount; ++column) {
        if (widths[static_cast<std::size_t>(column)] > 0) {
            table_->setColumnWidth(column, widths[static_cast<std::size_t>(column)]);
        }
    }
}

void PiecesPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate();  // gives the table its new width
    fillWidth();
}

void PiecesPanel::selectInTable() {
    if (synchronizing_) {
        return;
    }
    const QScopedValueRollback guard(synchronizing_, true);
    QItemSelection selection;
    for (const int piece : document_.selection()) {
        const QModelIndex index = sorted_->mapFromSource(model_->index(piece, 0));
        selection.select(index, index);
    }
    table_->selectionModel()->select(
        selection, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
    if (!selection.isEmpty()) {
        table_->scrollTo(selection.indexes().front());
    }
}

void PiecesPanel::selectInDocument() {
    if (synchronizing_) {
        return;
    }
    const QScopedValueRollback guard(synchronizing_, true);
    Document::Selection selection;
    for (const QModelIndex& index : table_->selectionModel()->selectedRows()) {
        selection.insert(sorted_->mapToSource(index).row());
    }
    document_.setSelection(std::move(selection));
    updateDetails();
}

void PiecesPanel::updateDetails() {
    const auto& selection = document_.selection();
    details_->setText(selection.size() == 1 ? details(*selection.begin()) : detailsOfMany());
}

QString PiecesPanel::details(int piece) const {
    const auto at = static_cast<std::size_t>(piece);
    const Piece& source = *document_.garment()->pieces[at];
    QString text = QString("<p><b>%1</b></p>").arg(pieceName(document_, piece).toHtmlEscaped());
    if (!document_.result(piece)) {
        return text + "<p>" + tr("Not flattened yet.").toHtmlEscaped() + "</p>";
    }
    const PieceResult& result = *document_.result(piece);
    if (result.error) {
        return text + "<p>" + whyNotFlat(document_, result).toHtmlEscaped() + "</p>";
    }
    const PieceQuality& quality = *result.quality;
    const QLocale locale;
    text += "<p>" + methodName(result.options.method).toHtmlEscaped() + "</p><table>";
    text += row(tr("Area, garment"), areaWithUnit(quality.area3d));
    text += row(tr("Area, flat"), areaWithUnit(quality.area2d));
    text += row(tr("Outline, garment"), lengthWithUnit(quality.perimeter3d));
    text += row(tr("Outline, flat"), lengthWithUnit(quality.perimeter2d));
    const QString error = boundaryError(quality.maxBoundaryLengthError);
    text += row(tr("Outline error"), error.at(0).isDigit() ? tr("%1 %").arg(error) : error);
    if (const QString changes = changeText(changesOf(result)); !changes.isEmpty()) {
        text += row(tr("Changed by"), tr("%1 %2").arg(changes, lengthUnit()).toHtmlEscaped());
    }
    if (quality.strainMeanAbs) {
        text += row(tr("Strain, mean"), tr("%1 %").arg(percent(*quality.strainMeanAbs)));
    }
    text += row(tr("Strain, range"), tr("%1 %").arg(strainRange(quality)));
    if (const auto fit = document_.referenceFit(piece)) {
        text += row(
            tr("To reference, rms / max"),
            QString("%1 / %2 %3").arg(fineLength(fit->rms), fineLength(fit->max), lengthUnit()));
    }
    if (quality.quasiConformalMean) {
        text += row(tr("Uneven stretch (1 = even)"),
                    locale.toString(*quality.quasiConformalMean, 'f', 3));
    }
    text += row(tr("Triangles"), locale.toString(static_cast<qlonglong>(source.mesh.F.rows())));
    text += row(tr("Time"), tr("%1 s").arg(locale.toString(result.seconds, 'f', 3)));
    return text + "</table>";
}

QString PiecesPanel::detailsOfMany() const {
    const int count = document_.pieceCount();
    if (count == 0) {
        return {};
    }
    const auto& selection = document_.selection();
    double area = 0;
    int flat = 0, counted = 0, cut = 0;
    for (int i = 0; i < count; ++i) {
        if ((!selection.empty() && selection.count(i) == 0) || isLeftOut(document_, i)) {
            continue;
        }
        ++counted;
        cut += copiesOf(document_, i);
        const PieceResult* result = document_.result(i);
        if (result && result->quality) {
            ++flat;
            area += copiesOf(document_, i) * result->quality->area2d;
        }
    }
    const QString title = selection.empty() ? tr("The whole garment") : tr("Selected pieces");
    const QString hint =
        selection.empty() ? "<p>" +
                                tr("Select a piece in a view or in the table to see its figures.")
                                    .toHtmlEscaped() +
                                "</p>"
                          : QString();
    const QString toCut =
        cut == counted ? QString() : row(tr("Pieces to cut"), QLocale().toString(cut));
    return QString("<p><b>%1</b></p><table>%2%3%4</table>%5")
        .arg(
            title.toHtmlEscaped(), row(tr("Pieces, flat"), tr("%1 of %2").arg(flat).arg(counted)),
            toCut,
            row(tr("Minimum cloth needed"), flat > 0 ? areaWithUnit(area) : QString(QChar(0x2013))),
            hint);
}

}  // namespace toile::app
