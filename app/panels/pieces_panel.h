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

/// The table of pieces. What is changed in one of several selected rows is meant for all of them:
/// a click into a cell that can be changed leaves the selection as it is. The edit key (F2) edits
/// the name and the space bar turns the mirrored pair on and off, whichever cell has the
/// keyboard.
class PiecesView : public QTreeView {
    Q_OBJECT

public:
    explicit PiecesView(QWidget* parent = nullptr);

    /// Opens the editor of a cell, once that of another is closed; not while one is about to open.
    void openEditor(const QModelIndex& cell);

protected:
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                         const QEvent* event) const override;
};

/// Table of the pieces with their figures; beside it the selected piece in words. The table's
/// selection is the document's.
class PiecesPanel : public QWidget {
    Q_OBJECT

public:
    explicit PiecesPanel(Document& document, QWidget* parent = nullptr);

    QTreeView& table();
    /// Which columns there are to be.
    ColumnChooser& columns() { return *columns_; }
    /// Lets the selected piece's name be typed; nothing where none is selected, or several are.
    void editName();
    /// Of all selected pieces.
    void editQuantity();

signals:
    /// A piece was double-clicked or Enter pressed on it: it is to be shown.
    void activated();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeTable();
    void editCell(int piece, int column);
    /// Columns that a person has to ask for: of figures that few want, and where nothing is wrong.
    QStringList quietColumns() const;
    /// Every column as wide as its contents; what is wanting is taken from the widest.
    void fitColumns();
    void fillWidth();
    void onChanged(const DocumentChange& what);
    void selectInTable();
    void selectInDocument();
    void updateDetails();
    /// All that an edit of this piece's row is meant for.
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
    bool synchronizing_ = false;  ///< keeps the two selections from answering each other
};

}  // namespace toile::app
