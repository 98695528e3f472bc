// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeView>

namespace toile::app {

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

}  // namespace toile::app
