// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/pieces_model.h"

#include <QBrush>
#include <QFont>
#include <QGuiApplication>
#include <QIcon>
#include <QLocale>
#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <set>
#include <utility>

#include "app/document/document.h"
#include "app/document/piece_edits.h"
#include "app/render/colour_map.h"
#include "app/settings/length_display.h"
#include "app/text/error_text.h"
#include "app/text/figures.h"
#include "app/text/seam_fit.h"
#include "core/diagnose/doubt.h"
#include "core/project/layer_materials.h"

namespace toile::app {

namespace {

QIcon swatch(Rgb colour) {
    return paintedMark([colour](QPainter& painter) {
        painter.setPen(QPen(QColor(0, 0, 0, 90), 1.5));
        painter.setBrush(QColor(colour.r, colour.g, colour.b));
        painter.drawRoundedRect(QRectF(4, 4, 24, 24), 6, 6);
    });
}

/// Legible on light and dark backgrounds.
const QColor kTrouble(214, 72, 40), kDoubtful(191, 128, 0);

/// Shown for an unknown value.
constexpr QChar kUnknown(0x2013);
constexpr double kUnknownSort = -1;

}  // namespace

QString whyNotFlat(const Document& document, const PieceResult& result) {
    Error said = *result.error;
    said.subject = labelled(document.state().labels, std::move(said.subject));
    return errorText(said);
}

PiecesModel::PiecesModel(const Document& document, QObject* parent)
    : ColumnsModel(ColumnCount, parent), document_(document) {
    setRows(document.pieceCount());
    followLayers();
    connect(&document_, &Document::changed, this, &PiecesModel::onChanged);
    connect(&LengthDisplay::instance(), &LengthDisplay::changed, this, &PiecesModel::showAgain);
}

void PiecesModel::onChanged(const DocumentChange& what) {
    if (what.hasOtherPieces()) {
        beginResetModel();
        setRows(document_.pieceCount());
        followLayers();
        endResetModel();
        return;
    }
    if (what.touches(&Derived::garment)) {
        followLayers();  // layers depend on how files are read
    }
    if (what.touchesContent() || what.touches(DocumentChange::ReferenceMatch)) {
        showColumns(0, ColumnCount - 1);
    }
}

void PiecesModel::followLayers() {
    layers_ = document_.garment() ? layersOf(*document_.garment()) : std::vector<int>();
}

QVariant PiecesModel::data(const QModelIndex& index, int role) const {
    // Between a change and the reset after it, there may be more rows than pieces.
    if (!index.isValid() || index.row() >= std::min(rowCount(), document_.pieceCount())) {
        return {};
    }
    const int row = index.row(), column = index.column();
    switch (role) {
        case Qt::EditRole:
            return column == Name       ? QVariant(pieceName(document_, row))
                   : column == Quantity ? QVariant(settings(row).quantity)
                                        : QVariant();
        case Qt::CheckStateRole:
            return column == Pair
                       ? QVariant(settings(row).mirroredPair ? Qt::Checked : Qt::Unchecked)
                       : QVariant();
        case Qt::ToolTipRole:
            return toolTip(row, column);
        case Qt::DecorationRole:
            return column == Name ? decoration(row) : QVariant();
        case Qt::ForegroundRole:
            return foreground(row, column);
        default:
            return ColumnsModel::data(index, role);
    }
}

const PieceSettings& PiecesModel::settings(int row) const {
    return document_.settings()[static_cast<std::size_t>(row)];
}

Qt::ItemFlags PiecesModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = ColumnsModel::flags(index);
    if (!index.isValid()) {
        return usual;
    }
    switch (index.column()) {
        case Name:
        case Quantity:
            return usual | Qt::ItemIsEditable;
        case Pair:
            return usual | Qt::ItemIsUserCheckable;
        default:
            return usual;
    }
}

bool PiecesModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid()) {
        return false;
    }
    if (index.column() == Name && role == Qt::EditRole) {
        emit nameWanted(index.row(), value.toString());
        return true;
    }
    if (index.column() == Quantity && role == Qt::EditRole) {
        emit quantityWanted(index.row(), value.toInt());
        return true;
    }
    if (index.column() == Pair && role == Qt::CheckStateRole) {
        emit pairWanted(index.row(), value.toInt() == Qt::Checked);
        return true;
    }
    return false;
}

bool PiecesModel::hasReference() const {
    const auto& results = document_.results();
    return document_.state().reference.file ||
           std::any_of(results.begin(), results.end(), [](const auto& result) {
               return result && result->quality && result->quality->reference;
           });
}

bool PiecesModel::hasMaterials() const {
    return std::ranges::any_of(document_.settings(), [](const PieceSettings& settings) {
        return !settings.material.empty();
    });
}

bool PiecesModel::isTelling(int column) const {
    std::set<toile::Method> methods;
    for (int row = 0; row < document_.pieceCount(); ++row) {
        if (const PieceResult* known = document_.result(row)) {
            methods.insert(known->options.method);
        }
        if ((column != Method && isTrouble(row, column)) ||
            (column == Status && isBeyondCloth(row))) {
            return true;
        }
    }
    return column == Method && methods.size() > 1;
}

QVariant PiecesModel::decoration(int row) const {
    const PieceResult* known = document_.result(row);
    return swatch(known && known->flat ? pieceColour(document_.colourOf(row)) : neutralColour());
}

PiecesModel::Cell PiecesModel::cell(int row, int column) const {
    const Piece& piece = *document_.garment()->pieces[static_cast<std::size_t>(row)];
    const PieceResult* known = document_.result(row);
    const auto triangles = static_cast<qlonglong>(piece.mesh.F.rows());
    const auto distance = [](const std::optional<ReferenceFit>& fit,
                             double ReferenceFit::*which) -> Cell {
        return fit ? Cell{fineLength((*fit).*which), (*fit).*which} : Cell{kUnknown, kUnknownSort};
    };
    switch (column) {
        case Name:
            return {pieceName(document_, row)};
        case Triangles:
            return {QLocale().toString(triangles), triangles};
        case Quantity:
            return {QLocale().toString(settings(row).quantity), settings(row).quantity};
        case Pair:
            return {{}, settings(row).mirroredPair ? 1 : 0};  // shown as a check box
        case MaterialName:
            return {QString::fromStdString(settings(row).material)};
        case Layer: {
            const auto at = static_cast<std::size_t>(row);
            const int layer = at < layers_.size() ? layers_[at] + 1 : 1;
            return {QLocale().toString(layer), layer};
        }
        case Method:
            return {known ? methodName(known->options.method) : QString(kUnknown)};
        case Status:
            if (isLeftOut(document_, row)) {
                return {tr("Left out")};
            }
            if (isHidden(document_, row) && known && known->flat) {
                return {tr("Flat, hidden")};
            }
            if (known && known->error) {
                // Short enough for a table; the whole sentence is in the tool tip and the details.
                return {tr("Not flat: %1").arg(troubleText(*known->error, *known->piece))};
            }
            return {!known                       ? tr("Waiting")
                    : statusOf(*known) != "flat" ? tr("Partly flipped")
                    : isBeyondCloth(row)         ? tr("Flat, exceeds any fabric")
                                                 : tr("Flat")};
        case ReferenceRms:
            return distance(document_.referenceFit(row), &ReferenceFit::rms);
        case ReferenceMax:
            return distance(document_.referenceFit(row), &ReferenceFit::max);
        default:
            return known && known->quality ? figure(*known->quality, column)
                                           : Cell{kUnknown, kUnknownSort};
    }
}

QString PiecesModel::toolTip(int row, int column) const {
    const PieceResult* known = document_.result(row);
    switch (column) {
        case Status:
            return known && known->error ? whyNotFlat(document_, *known)
                   : known && isBeyondCloth(row)
                       ? tr("No fabric can take this strain. Cut the piece where it curves most.")
                       : cell(row, column).text;
        case Name:
            return tr("%1. Double-click or press F2 to rename it").arg(cell(row, column).text);
        case Quantity:
            return tr("Number to cut. Double-click to change it for all selected pieces");
        case Pair:
            return settings(row).mirroredPair
                       ? tr("A mirrored copy is also cut. Click or press Space to change this")
                       : tr("No mirrored copy is cut. Click or press Space to cut left and right");
        case Method:
            if (!known) {
                return tr("Not flattened yet");
            }
            return isStale(row) ? tr("%1 – out of date: shape or method has changed since")
                                      .arg(methodName(known->options.method))
                                : methodName(known->options.method);
        case ReferenceRms:
        case ReferenceMax:
            return document_.reference() ? partnerText(row) : cell(row, column).text;
        default:
            return cell(row, column).text;
    }
}

QString PiecesModel::partnerText(int row) const {
    const ReferenceMatch& found = *document_.reference();
    const PieceMatch* pair = pairOf(found.match, row);
    const auto nameOfPiece = [&found](int piece) {
        return QString::fromStdString(found.file->pieces[static_cast<std::size_t>(piece)].name);
    };
    if (!pair) {
        return tr("No piece of the reference pattern matches this one");
    }
    if (!isSure(*pair)) {
        QStringList names{nameOfPiece(pair->filePiece)};
        for (const int rival : pair->rivals) {
            names << nameOfPiece(rival);
        }
        return tr("Several pieces of the reference pattern match: %1").arg(names.join(", "));
    }
    const QString name = nameOfPiece(pair->filePiece);
    if (pair->isDoubtful()) {
        return tr("Compared with %1 of the reference pattern; uncertain, because the sizes differ")
            .arg(name);
    }
    return pair->lines.front().fit.mirrored
               ? tr("Compared with %1 of the reference pattern, mirrored").arg(name)
               : tr("Compared with %1 of the reference pattern").arg(name);
}

QVariant PiecesModel::foreground(int row, int column) const {
    if (isLeftOut(document_, row) || isHidden(document_, row)) {
        return QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
    }
    if (isTrouble(row, column)) {
        return QBrush(kTrouble);
    }
    if (column == Status && isBeyondCloth(row)) {
        return QBrush(kDoubtful);
    }
    if (column == Method && isStale(row)) {
        return QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
    }
    return {};
}

bool PiecesModel::isStale(int row) const {
    const PieceResult* known = document_.result(row);
    return known && (known->piece != document_.garment()->pieces[static_cast<std::size_t>(row)] ||
                     !(known->options == document_.options()));
}

PiecesModel::Cell PiecesModel::figure(const PieceQuality& quality, int column) {
    const auto count = [](int number) -> Cell { return {QLocale().toString(number), number}; };
    switch (column) {
        case Area:
            return {areaNumber(quality.area2d), quality.area2d};
        case Outline:
            return {lengthNumber(quality.perimeter2d), quality.perimeter2d};
        case OutlineError:
            return {boundaryError(quality.maxBoundaryLengthError), quality.maxBoundaryLengthError};
        case StrainMean:
            return {quality.strainMeanAbs ? percent(*quality.strainMeanAbs) : QString(kUnknown),
                    quality.strainMeanAbs.value_or(kUnknownSort)};
        case StrainRange:
            return {strainRange(quality),
                    quality.strainMax.value_or(-1.0) - quality.strainMin.value_or(0.0)};
        case Flips:
            return count(quality.flippedTriangles);
        case Crossings:
            return count(quality.outlineCrossings);
        default:
            return {};
    }
}

bool PiecesModel::isBeyondCloth(int row) const {
    const PieceResult* known = document_.result(row);
    return known && known->quality && known->quality->strainMeanAbs > kStrainBeyondCloth;
}

bool PiecesModel::isTrouble(int row, int column) const {
    const PieceResult* known = document_.result(row);
    if (!known) {
        return false;
    }
    if (column == Status) {
        return statusOf(*known) != "flat";
    }
    if (!known->quality) {
        return false;
    }
    return (column == Flips && known->quality->flippedTriangles > 0) ||
           (column == Crossings && known->quality->outlineCrossings > 0);
}

std::vector<PiecesModel::Heading> PiecesModel::headings() const {
    return {
        {tr("Piece"), tr("Name of the piece and its colour in the views")},
        {tr("Status"), tr("Whether the piece is flat, or why not")},
        {tr("Quantity"), tr("Number of copies to cut")},
        {tr("Pair"), tr("Also cut a mirrored copy of each: left and right")},
        {tr("Material"), tr("Material of the piece; empty: garment's fabric")},
        {tr("Layer"), tr("Layer of cloth that the piece belongs to; 1 is the outermost")},
        {tr("Method"), tr("Flattening method of the piece; grey if the result is out of date")},
        {tr("Triangles"), tr("Number of triangles in the mesh")},
        {tr("Area %1").arg(areaUnit()), tr("Area of the flat piece")},
        {tr("Outline %1").arg(lengthUnit()), tr("Length of the seam line around the flat piece")},
        {tr("Outline error %"),
         tr("Largest length difference of an outline edge between pattern and garment")},
        {tr("Mean strain %"), tr("Mean size of stretch and surplus")},
        {tr("Strain range %"), tr("From the largest surplus to the largest stretch; + is stretch")},
        {tr("Flips"), tr("Triangles that are flipped in the pattern: must be 0")},
        {tr("Crossings"), tr("Points where the outline crosses itself: must be 0")},
        {tr("To reference rms %1").arg(lengthUnit()),
         tr("Root mean square distance from the best-fitting reference panel or pattern")},
        {tr("To reference max %1").arg(lengthUnit()),
         tr("Largest distance from the reference panel or pattern")},
    };
}

}  // namespace toile::app
