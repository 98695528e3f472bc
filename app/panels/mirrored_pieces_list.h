// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>
#include <set>
#include <vector>

#include "app/document/symmetry_facts.h"

namespace toile::app {

class Document;

/// The pieces that mirror each other, or themselves: by how much they differ, whether they are
/// drawn equal, and a check box each for whether one half of them is enough.
class MirroredPiecesList : public QTreeWidget {
    Q_OBJECT

public:
    enum Column { Name, Deviation, Drawn, Half, ColumnCount };

    explicit MirroredPiecesList(QWidget* parent = nullptr);

    /// @param facts  of the document's garment as it is shown
    void show(const Document& document, const SymmetryFacts& facts);
    /// Selects the row that holds all of these pieces, or none.
    void select(const std::set<int>& pieces);

signals:
    /// @param row  its place in SymmetryFacts::rows
    void halfWanted(int row, bool byHalf);
    /// A person has chosen a row.
    void rowChosen(int row);

private:
    /// A short word, and the whole of it for a tool tip.
    struct Words {
        QString word, tip;
    };

    static Words drawnWords(const Document& document, const MirroredPieces& row);
    static QString equalTip(const Document& document, const MirroredPieces& row);
    static void fill(QTreeWidgetItem& item, const Document& document, const MirroredPieces& row);

    bool fills_ = false;  ///< not a person
    std::vector<MirroredPieces> rows_;
};

}  // namespace toile::app
