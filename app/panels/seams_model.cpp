// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/seams_model.h"

#include <QApplication>
#include <QBrush>
#include <QFont>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "app/base/text.h"
#include "app/document/document.h"
#include "app/settings/length_display.h"
#include "app/text/figures.h"
#include "app/text/seam_fit.h"
#include "core/pattern/line_fields.h"
#include "core/pattern/pattern.h"

namespace toile::app {

namespace {

constexpr QChar kDash(0x2013);
/// Tint of an error's background: strong enough to notice, weak enough to read text on.
constexpr float kTint = 0.30F;

QString kindWord(SeamKind kind) {
    switch (kind) {
        case SeamKind::Seam:
            return SeamsModel::tr("seam");
        case SeamKind::Dart:
            return SeamsModel::tr("dart");
        case SeamKind::Fold:
            return SeamsModel::tr("pleat");
        case SeamKind::Free:
            return SeamsModel::tr("free edge");
    }
    return {};
}

}  // namespace

SeamsModel::SeamsModel(const Document& document, QObject* parent)
    : ColumnsModel(ColumnCount, parent), document_(document) {
    connect(&document_, &Document::changed, this, &SeamsModel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &SeamsModel::showAgain);
}

void SeamsModel::onChanged(const DocumentChange& what) {
    if (what.hasOtherPieces() && !hasTheSameRows()) {
        beginResetModel();
        measureAll();
        endResetModel();
    } else if (what.touches(&Derived::garment, &Derived::results, &Derived::pattern,
                            &DocumentState::labels) &&
               rowCount() > 0) {
        measureAll();
        showColumns(0, ColumnCount - 1);
    }
}

void SeamsModel::measureAll() {
    garment_ = document_.garment();
    measures_.clear();
    changes_.clear();
    for (int i = 0; i < document_.seamCount(); ++i) {
        measures_.push_back(measured(*garment_, document_.results(), i));
        changes_.push_back(changesOf(seam(i), document_.results()));
    }
    setRows(static_cast<int>(measures_.size()));
}

bool SeamsModel::hasTheSameRows() const {
    if (!garment_ || !document_.garment()) {
        return garment_ == document_.garment();
    }
    return std::ranges::equal(garment_->seams.seams, document_.garment()->seams.seams, {},
                              &Seam::name, &Seam::name);
}

const Seam& SeamsModel::seam(int row) const {
    return garment_->seams.seams[static_cast<std::size_t>(row)];
}

Qt::ItemFlags SeamsModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = ColumnsModel::flags(index);
    const bool eased =
        index.isValid() && index.column() == Ease && seam(index.row()).kind != SeamKind::Free;
    const bool drawable =
        index.isValid() && index.column() == Drawn && seam(index.row()).ease.has_value();
    return eased ? usual | Qt::ItemIsEditable : drawable ? usual | Qt::ItemIsUserCheckable : usual;
}

bool SeamsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role == Qt::CheckStateRole && garment_ == document_.garment() &&
        flags(index).testFlag(Qt::ItemIsUserCheckable)) {
        emit drawingWanted(index.row(), value.toInt() == Qt::Checked);
        return true;
    }
    if (role != Qt::EditRole || garment_ != document_.garment() ||
        !flags(index).testFlag(Qt::ItemIsEditable)) {
        return false;
    }
    const std::optional<EnteredPercent> ease = parsePercent(value.toString());
    if (!ease) {
        return false;
    }
    emit easeWanted(index.row(), ease->fraction);
    return true;
}

QVariant SeamsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const int row = index.row(), column = index.column();
    const bool stated = column == Ease && seam(row).ease.has_value();
    switch (role) {
        case Qt::EditRole:
            return stated ? cell(row, column).text : QString();
        case Qt::ToolTipRole:
            return tip(row, column);
        case Qt::CheckStateRole:
            return column == Drawn && seam(row).ease
                       ? QVariant(seam(row).drawn ? Qt::Checked : Qt::Unchecked)
                       : QVariant();
        case Qt::DecorationRole:
            return column == Fit
                       ? QVariant(fitMark(seamFit(seam(row), measures_[std::size_t(row)])))
                       : QVariant();
        case Qt::BackgroundRole:
            return background(row, column);
        case Qt::FontRole: {
            QFont font = QApplication::font("QAbstractItemView");
            font.setBold(stated);
            return column == Ease ? QVariant(font) : QVariant();
        }
        case Qt::ForegroundRole:
            return column == Ease && !stated
                       ? QVariant(QApplication::palette().brush(QPalette::PlaceholderText))
                       : QVariant();
        case FreeRole:
            return seam(row).kind == SeamKind::Free;
        default:
            return ColumnsModel::data(index, role);
    }
}

QVariant SeamsModel::background(int row, int column) const {
    const SeamFit fit = seamFit(seam(row), measures_[static_cast<std::size_t>(row)]);
    if (column != Error || fit == SeamFit::Unknown) {
        return {};
    }
    QColor tint = fitColour(fit);
    tint.setAlphaF(kTint);
    return QBrush(tint);
}

QString SeamsModel::edgeWord(int row) const {
    const Seam& free = seam(row);
    if (const PatternPiece* piece = document_.patternPiece(free.left.piece);
        piece && free.kind == SeamKind::Free) {
        const auto edge = std::ranges::find(piece->segments, row + 1, &PatternSegment::seam);
        if (edge != piece->segments.end() && edge->edge != EdgeKind::Unknown) {
            return app::tr(kEdgeKindNames[static_cast<std::size_t>(edge->edge)]);
        }
    }
    return kindWord(free.kind);
}

SeamsModel::Cell SeamsModel::cell(int row, int column) const {
    const Seam& asked = seam(row);
    const auto& measure = measures_[static_cast<std::size_t>(row)];
    const bool sewn = asked.kind != SeamKind::Free;
    const SeamMeasure known = measure.value_or(SeamMeasure{});
    const auto figure = [&](const QString& text, double sort) -> Cell {
        return {measure && (sewn || column == FlatLeft) ? text : QString(kDash), sort};
    };
    // As shown, so that rounding noise does not shuffle seams that all match.
    const double residual = measure && sewn ? std::round(100 * std::abs(known.errorMm)) : -1;
    switch (column) {
        case Number:
            return {QString::number(row + 1), row};
        case Name:
            return {seamName(document_, row)};
        case Kind:
            return {edgeWord(row)};
        case Length3d: {
            const QString left = lengthNumber(asked.length3d[0]);
            const QString right = lengthNumber(asked.length3d[1]);
            return {!sewn || left == right ? left : tr("%1 / %2").arg(left, right),
                    asked.length3d[0]};
        }
        case FlatLeft:
            return figure(lengthNumber(known.length2dLeft), measure ? known.length2dLeft : -1);
        case FlatRight:
            return figure(lengthNumber(known.length2dRight), measure ? known.length2dRight : -1);
        case Difference:
            return figure(signedFineLength(known.deltaMm), known.deltaMm);
        case Ease:
            return {sewn ? signedNumber(100 * easeOf(asked), 1) : QString(kDash), easeOf(asked)};
        case Drawn:
            return {QString(), asked.drawn ? 2 : asked.ease ? 1 : 0};
        case ChangedBy: {
            double largest = 0;
            for (const LengthChange& change : changes_[static_cast<std::size_t>(row)]) {
                largest = std::max(largest, std::abs(change.millimetres));
            }
            return {changeText(changes_[static_cast<std::size_t>(row)]), largest};
        }
        case Error:
            return figure(signedFineLength(known.errorMm), residual);
        case Fit:
            return {measure && sewn ? fitWord(seamFit(asked, measure)) : QString(), residual};
        default:
            return {};
    }
}

QString SeamsModel::tip(int row, int column) const {
    const Seam& asked = seam(row);
    if (column != Ease || asked.kind == SeamKind::Free) {
        return column == Name && asked.stacked
                   ? tr("%1: a third layer in this seam").arg(cell(row, column).text)
                   : cell(row, column).text;
    }
    return asked.ease ? tr("Set by you. Press Delete to reset it to the 3D lengths.")
                      : tr("From the 3D lengths. Double-click or press F2 to set your own ease.");
}

QString SeamsModel::summary() const {
    return measures_.empty() ? QString() : seamSummary(garment_->seams, measures_);
}

std::vector<SeamsModel::Heading> SeamsModel::headings() const {
    return {
        {tr("No."), tr("Number of the seam in the garment")},
        {tr("Seam"), tr("The pieces sewn together; the left one is named first")},
        {tr("Kind"), tr("Seam, dart, pleat or free edge")},
        {tr("3D %1").arg(lengthUnit()), tr("Length on the garment; left / right if they differ")},
        {tr("Flat left %1").arg(lengthUnit()),
         tr("Length of the left piece's edge in the pattern")},
        {tr("Flat right %1").arg(lengthUnit()),
         tr("Length of the right piece's edge in the pattern")},
        {tr("Difference %1").arg(lengthUnit()),
         tr("Flat left minus flat right: the length to ease in when sewing")},
        {tr("Ease %"), tr("How much longer the left edge is. Grey: from the garment; bold: set by "
                          "you. Double-click or F2: set, Delete: reset")},
        {tr("Drawn"), tr("Whether the pattern draws the longer edge with your ease")},
        {tr("Changed by %1").arg(lengthUnit()),
         tr("Why and by how much the seam length differs from the garment")},
        {tr("Error %1").arg(lengthUnit()),
         tr("Difference that remains after subtracting the ease")},
        {tr("Fit"), tr("Matches: up to %1; nearly: up to %2; does not match: above")
                        .arg(fineLength(kMatchesMm) + ' ' + lengthUnit(),
                             fineLength(kNearlyMm) + ' ' + lengthUnit())},
    };
}

}  // namespace toile::app
