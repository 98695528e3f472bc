// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pieces_model.h"

#include <QBrush>
#include <QFont>
#include <QIcon>
#include <QLocale>
#include <QPainter>
#include <QPixmap>
#include <algorithm>

#include "app/document/document.h"
#include "app/panels/figures.h"
#include "app/render/colour_map.h"

namespace toile {

namespace {

QIcon swatch(Rgb colour) {
    QPixmap pixmap(32, 32);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0, 0, 0, 90), 1.5));
    painter.setBrush(QColor(colour.r, colour.g, colour.b));
    painter.drawRoundedRect(QRectF(4, 4, 24, 24), 6, 6);
    QIcon icon(pixmap);
    // Not tinted in a selected row: it is the piece's colour.
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

/// Legible on light and dark alike.
const QColor kTrouble(214, 72, 40);

}  // namespace

PiecesModel::PiecesModel(const Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
    connect(&document_, &Document::changed, this, &PiecesModel::onChanged);
}

void PiecesModel::onChanged(DocumentChanges what) {
    if (what.testFlag(DocumentChange::Garment)) {
        beginResetModel();
        endResetModel();
    } else if (what.testFlag(DocumentChange::Results) && rowCount() > 0) {
        emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    }
}

int PiecesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : document_.pieceCount();
}

int PiecesModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

const PieceResult* PiecesModel::result(int row) const {
    const auto at = static_cast<std::size_t>(row);
    return at < document_.results().size() ? document_.results()[at].get() : nullptr;
}

QVariant PiecesModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const int row = index.row(), column = index.column();
    switch (role) {
        case Qt::DisplayRole:
            return text(row, column);
        case Qt::ToolTipRole:
            return column == Status && result(row) && result(row)->error
                       ? QString::fromStdString(sentence(*result(row)->error))
                       : text(row, column);
        case Qt::DecorationRole:
            return column == Name ? decoration(row) : QVariant();
        case Qt::TextAlignmentRole:
            return column <= Status ? int(Qt::AlignLeft | Qt::AlignVCenter)
                                    : int(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ForegroundRole:
            return isTrouble(row, column) ? QVariant(QBrush(kTrouble)) : QVariant();
        case SortRole:
            return sortValue(row, column);
        default:
            return {};
    }
}

bool PiecesModel::hasDesigner() const {
    const auto& results = document_.results();
    return std::any_of(results.begin(), results.end(), [](const auto& result) {
        return result->quality && result->quality->reference;
    });
}

QVariant PiecesModel::decoration(int row) const {
    const PieceResult* known = result(row);
    return swatch(known && known->flat ? pieceColour(row) : neutralColour());
}

QString PiecesModel::text(int row, int column) const {
    const Piece& piece = *document_.garment()->pieces[static_cast<std::size_t>(row)];
    const PieceResult* known = result(row);
    switch (column) {
        case Name:
            return QString::fromStdString(piece.name);
        case Triangles:
            return QLocale().toString(static_cast<qlonglong>(piece.mesh.F.rows()));
        case Status:
            if (known && known->error) {
                // Short enough for a table; the whole sentence is in the tool tip and the details.
                const std::string_view reason = name(known->error->code);
                return tr("Not flat: %1")
                    .arg(QString::fromUtf8(reason.data(), static_cast<qsizetype>(reason.size()))
                             .replace('-', ' '));
            }
            return known ? tr("Flat") : tr("Waiting");
        default:
            return known && known->quality ? measuredText(*known, column) : QString(QChar(0x2013));
    }
}

QString PiecesModel::measuredText(const PieceResult& known, int column) const {
    const PieceQuality& quality = *known.quality;
    switch (column) {
        case Area:
            return squareCentimetres(quality.area2d);
        case Outline:
            return centimetres(quality.perimeter2d);
        case OutlineError:
            return boundaryError(quality.maxBoundaryLengthError);
        case StrainMean:
            return quality.strainMeanAbs ? percent(*quality.strainMeanAbs) : QString(QChar(0x2013));
        case StrainRange:
            return strainRange(quality);
        case Flips:
            return QLocale().toString(quality.flippedTriangles);
        case Crossings:
            return QLocale().toString(quality.outlineCrossings);
        case DesignerRms:
        case DesignerMax:
            return quality.reference
                       ? QLocale().toString(column == DesignerRms ? quality.reference->rms
                                                                  : quality.reference->max,
                                            'f', 2)
                       : QString(QChar(0x2013));
        default:
            return {};
    }
}

QVariant PiecesModel::sortValue(int row, int column) const {
    const Piece& piece = *document_.garment()->pieces[static_cast<std::size_t>(row)];
    const PieceResult* known = result(row);
    if (column == Name || column == Status) {
        return text(row, column);
    }
    if (column == Triangles) {
        return static_cast<qlonglong>(piece.mesh.F.rows());
    }
    if (!known || !known->quality) {
        return -1.0;
    }
    const PieceQuality& quality = *known->quality;
    switch (column) {
        case Area:
            return quality.area2d;
        case Outline:
            return quality.perimeter2d;
        case OutlineError:
            return quality.maxBoundaryLengthError;
        case StrainMean:
            return quality.strainMeanAbs.value_or(-1.0);
        case StrainRange:
            return quality.strainMax.value_or(-1.0) - quality.strainMin.value_or(0.0);
        case Flips:
            return quality.flippedTriangles;
        case Crossings:
            return quality.outlineCrossings;
        case DesignerRms:
            return quality.reference ? quality.reference->rms : -1.0;
        case DesignerMax:
            return quality.reference ? quality.reference->max : -1.0;
        default:
            return {};
    }
}

bool PiecesModel::isTrouble(int row, int column) const {
    const PieceResult* known = result(row);
    if (!known) {
        return false;
    }
    if (column == Status) {
        return known->error.has_value();
    }
    if (!known->quality) {
        return false;
    }
    return (column == Flips && known->quality->flippedTriangles > 0) ||
           (column == Crossings && known->quality->outlineCrossings > 0);
}

QVariant PiecesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    struct Header {
        QString title, tip;
    };
    const Header headers[ColumnCount] = {
        {tr("Piece"), tr("Name of the piece and its colour in the views")},
        {tr("Status"), tr("Flat, or why not")},
        {tr("Triangles"), tr("Triangles of the mesh")},
        {tr("Area cm²"), tr("Area of the flat piece")},
        {tr("Outline cm"), tr("Length of the flat piece's seam line all around")},
        {tr("Outline error %"),
         tr("Largest difference of an outline edge between the flat piece and the garment")},
        {tr("Mean strain %"), tr("Mean size of what the cloth must stretch or gather")},
        {tr("Strain range %"), tr("From most surplus to most stretch; + is stretch")},
        {tr("Flips"), tr("Triangles that lie upside down in the pattern: must be 0")},
        {tr("Crossings"), tr("Places where the outline crosses itself: must be 0")},
        {tr("To designer rms mm"), tr("Distance from the designer's own panel, laid on as well as "
                                      "it goes: root mean square")},
        {tr("To designer max mm"), tr("Distance from the designer's own panel: the largest")},
    };
    if (role == Qt::DisplayRole) {
        return headers[section].title;
    }
    if (role == Qt::ToolTipRole) {
        return headers[section].tip;
    }
    if (role == Qt::TextAlignmentRole) {
        return section <= Status ? int(Qt::AlignLeft | Qt::AlignVCenter)
                                 : int(Qt::AlignRight | Qt::AlignVCenter);
    }
    return {};
}

}  // namespace toile
