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

/// Why a piece is not flat, by what a person calls it. Precondition: there is an error.
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
    /// Changes nothing itself: see the signals.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    /// True where a reference pattern is open, or a flat piece carries the reference panel.
    bool hasReference() const;
    /// True where a piece is cut from another fabric than the garment's own.
    bool hasMaterials() const;
    /// True where the garment is of several layers of cloth.
    bool hasLayers() const { return !layers_.empty(); }
    /// Whether some piece has a flip, or a crossing; or pieces were flattened by different methods.
    /// @param column  Flips, Crossings or Method
    bool isTelling(int column) const;

signals:
    /// A person has typed another name for a piece.
    void nameWanted(int piece, const QString& name);
    /// A person has typed another quantity into a row, or checked it as a mirrored pair or not.
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
    /// Whether the mean strain is more than any cloth takes.
    bool isBeyondCloth(int row) const;
    /// A figure of a flat piece.
    static Cell figure(const PieceQuality& quality, int column);
    QVariant decoration(int row) const;
    QString toolTip(int row, int column) const;
    /// What the piece is compared with. Precondition: the document's reference is known.
    QString partnerText(int row) const;
    QVariant foreground(int row, int column) const;
    bool isTrouble(int row, int column) const;
    /// True where the piece's result was made from another shape or in another way than is asked
    /// for now.
    bool isStale(int row) const;

    const Document& document_;
    std::vector<int> layers_;  ///< per piece, from the outermost, 0; or empty
};

}  // namespace toile::app
