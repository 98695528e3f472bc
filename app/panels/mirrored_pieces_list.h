// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>
#include <set>
#include <vector>

#include "app/document/symmetry_facts.h"

namespace toile::app {

class Document;

/// Lists pieces that mirror each other or themselves: how much they differ, whether they are drawn
/// equal, and a check box for drawing only one half.
class MirroredPiecesList : public QTreeWidget {
    Q_OBJECT

public:
    enum Column { Name, Deviation, Drawn, Half, ColumnCount };

    explicit MirroredPiecesList(QWidget* parent = nullptr);

    /// @param facts  of the document's current garment
    void show(const Document& document, const SymmetryFacts& facts);
    /// Selects the row that contains all of these pieces, if any.
    void select(const std::set<int>& pieces);

signals:
    /// @param row  index into SymmetryFacts::rows
    void halfWanted(int row, bool byHalf);
    /// The user selected a row.
    void rowChosen(int row);

private:
    /// A short word, and the full text for a tool tip.
    struct Words {
        QString word, tip;
    };

    static Words drawnWords(const Document& document, const MirroredPieces& row);
    static QString equalTip(const Document& document, const MirroredPieces& row);
    static void fill(QTreeWidgetItem& item, const Document& document, const MirroredPieces& row);

    bool fills_ = false;  ///< rows are changed by code, not by the user
    std::vector<MirroredPieces> rows_;
};

}  // namespace toile::app
