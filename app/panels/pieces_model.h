// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "app/document/document_change.h"

namespace toile {

class Document;
struct PieceResult;

/// The document's pieces as a table: row i is piece i. Sorts by `SortRole`.
class PiecesModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        Name,
        Status,
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
    /// True for columns about the designer's own panels.
    static constexpr bool isAboutDesigner(int column) {
        return column == DesignerRms || column == DesignerMax;
    }

    explicit PiecesModel(const Document& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// True where a flat piece carries the designer's own panel.
    bool hasDesigner() const;

private:
    void onChanged(DocumentChanges what);
    const PieceResult* result(int row) const;
    QString text(int row, int column) const;
    QString measuredText(const PieceResult& result, int column) const;
    QVariant sortValue(int row, int column) const;
    QVariant decoration(int row) const;
    bool isTrouble(int row, int column) const;

    const Document& document_;
};

}  // namespace toile
