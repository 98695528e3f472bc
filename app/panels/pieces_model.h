// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/widgets/columns_model.h"

namespace toile {
struct PieceQuality;
struct PieceResult;
struct PieceSettings;
}  // namespace toile

namespace toile::app {

class Document;
class DocumentChange;

/// Explains why a piece is not flat, using its displayed name. Precondition: there is an error.
QString whyNotFlat(const Document& document, const PieceResult& result);

/// The document's pieces as a table: row i is piece i.
class PiecesModel : public ColumnsModel {
    Q_OBJECT

public:
    enum Column {
        Name,
        Status,
        Quantity,
        Pair,
        MaterialName,
        Layer,
        Method,
        Triangles,
        Area,
        Outline,
        OutlineError,
        StrainMean,
        StrainRange,
        Flips,
        Crossings,
        ReferenceRms,
        ReferenceMax,
        ColumnCount
    };
    /// True for columns about the reference panels.
    static constexpr bool isAboutReference(int column) {
        return column == ReferenceRms || column == ReferenceMax;
    }

    explicit PiecesModel(const Document& document, QObject* parent = nullptr);

    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Only emits the signals; does not change the document.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    /// True if a reference pattern is open, or a flat piece carries the reference panel.
    bool hasReference() const;
    /// True if a piece is cut from another fabric than the garment's own.
    bool hasMaterials() const;
    /// True if the garment has several layers of cloth.
    bool hasLayers() const { return !layers_.empty(); }
    /// True if the column is worth showing: a piece has a flip or a crossing, or methods differ.
    /// @param column  Flips, Crossings or Method
    bool isTelling(int column) const;

signals:
    /// The user renamed a piece.
    void nameWanted(int piece, const QString& name);
    /// The user changed the quantity of a piece, or whether it is a mirrored pair.
    void quantityWanted(int piece, int quantity);
    void pairWanted(int piece, bool isPair);

protected:
    std::vector<Heading> headings() const override;
    bool isWords(int column) const override {
        return column == Name || column == Status || column == Pair || column == MaterialName ||
               column == Method;
    }
    Cell cell(int row, int column) const override;

private:
    void onChanged(const DocumentChange& what);
    void followLayers();
    const PieceSettings& settings(int row) const;
    /// True if the mean strain is more than any cloth can take.
    bool isBeyondCloth(int row) const;
    /// A measured value of a flat piece.
    static Cell figure(const PieceQuality& quality, int column);
    QVariant decoration(int row) const;
    QString toolTip(int row, int column) const;
    /// What the piece is compared with. Precondition: the document's reference is known.
    QString partnerText(int row) const;
    QVariant foreground(int row, int column) const;
    bool isTrouble(int row, int column) const;
    /// True if the result was computed from another shape or with other settings than the current
    /// ones.
    bool isStale(int row) const;

    const Document& document_;
    std::vector<int> layers_;  ///< of each piece, 0 is the outermost; or empty
};

}  // namespace toile::app
