// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "app/document/document_change.h"

namespace toile {

class Document;
struct PieceResult;
struct PieceSettings;

/// The document's pieces as a table: row i is piece i. Sorts by `SortRole`.
class PiecesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        Name,
        Status,
        Quantity,
        Pair,
        Method,
        Triangles,
        Area,
        Outline,
        OutlineError,
        StrainMean,
        StrainRange,
        Flips,
        Crossings,
        DesignerRms,
        DesignerMax,
        ColumnCount
    };
    static constexpr int SortRole = Qt::UserRole;
    static constexpr bool isWords(int column) {
        return column == Name || column == Status || column == Pair || column == Method;
    }
    /// True for columns about the designer's own panels.
    static constexpr bool isAboutDesigner(int column) {
        return column == DesignerRms || column == DesignerMax;
    }

    explicit PiecesModel(const Document& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    /// Changes nothing itself: see the signals.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// True where a flat piece carries the designer's own panel.
    bool hasDesigner() const;

signals:
    /// A person has typed another quantity into a row, or checked it as a mirrored pair or not.
    void quantityWanted(int piece, int quantity);
    void pairWanted(int piece, bool isPair);

private:
    void onChanged(DocumentChanges what);
    void showAgain();
    void showColumns(int first, int last);
    const PieceSettings& settings(int row) const;
    QString text(int row, int column) const;
    QString measuredText(const PieceResult& result, int column) const;
    QVariant sortValue(int row, int column) const;
    QVariant decoration(int row) const;
    QString toolTip(int row, int column) const;
    QVariant foreground(int row, int column) const;
    bool isTrouble(int row, int column) const;
    /// True where the piece's result was made from another shape or in another way than is asked
    /// for now.
    bool isStale(int row) const;

    const Document& document_;
    int rows_ = 0;
};

}  // namespace toile
