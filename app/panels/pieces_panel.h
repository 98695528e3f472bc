// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeView>
#include <QWidget>
#include <vector>

class QLabel;
class QSortFilterProxyModel;
class QTreeView;

namespace toile::app {

class ColumnChooser;
class Document;
class DocumentChange;
class PiecesModel;

/// The table of pieces. An edit in one of several selected rows applies to all of them, so a click
/// on an editable cell keeps the selection. The edit key (F2) edits the name and the space bar
/// toggles the mirrored pair, whichever cell is current.
class PiecesView : public QTreeView {
    Q_OBJECT

public:
    explicit PiecesView(QWidget* parent = nullptr);

    /// Closes the editor of any other cell first. Precondition: no editor is just being opened.
    void openEditor(const QModelIndex& cell);

protected:
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                         const QEvent* event) const override;
};

/// Table of the pieces with their figures and details of the selected piece. The table and the
/// document share one selection.
class PiecesPanel : public QWidget {
    Q_OBJECT

public:
    explicit PiecesPanel(Document& document, QWidget* parent = nullptr);

    QTreeView& table();
    /// Chooses which columns are shown.
    ColumnChooser& columns() { return *columns_; }
    /// Edits the selected piece's name. Does nothing unless exactly one piece is selected.
    void editName();
    /// Edits the quantity of all selected pieces.
    void editQuantity();

signals:
    /// The user double-clicked a piece or pressed Enter on it, to see it.
    void activated();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeTable();
    void editCell(int piece, int column);
    /// Columns hidden by default: rarely needed figures, and those that show no trouble.
    QStringList quietColumns() const;
    /// Fits every column to its contents. If space is short, the widest ones shrink.
    void fitColumns();
    void fillWidth();
    void onChanged(const DocumentChange& what);
    void selectInTable();
    void selectInDocument();
    void updateDetails();
    /// The pieces that an edit of this piece's row applies to.
    std::vector<int> meantWith(int piece) const;
    QString details(int piece) const;
    QString detailsOfMany() const;

    Document& document_;
    PiecesModel* model_;
    QSortFilterProxyModel* sorted_;
    PiecesView* table_;
    ColumnChooser* columns_;
    QLabel* details_;
    std::vector<int> wanted_;     ///< widths that the contents need, pixels; 0: hidden
    bool synchronizing_ = false;  ///< prevents recursion between the two selections
};

}  // namespace toile::app
