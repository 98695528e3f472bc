// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "core/base/id.h"

class QCheckBox;
class QLabel;
class QSortFilterProxyModel;
class QStackedWidget;
class QTreeView;

namespace toile::app {

class ActionRegistry;
class Document;
class DocumentChange;
class SeamsModel;

/// The seam ledger: every seam with the lengths of its two sides, the worst first, and the list of
/// cuts. The table's selected row is the document's selected seam.
class SeamsPanel : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the panel.
    SeamsPanel(Document& document, const ActionRegistry& actions, QWidget* parent = nullptr);

    QTreeView& table() { return *table_; }
    /// Opens the editor for the selected seam's ease. Does nothing if no seam is selected.
    void editEase();

signals:
    /// The user double-clicked a seam or pressed Enter on it, to see it.
    void activated();
    /// @param ease  fraction of the right side's length; none: derived from the 3D lengths
    void easeWanted(int seam, std::optional<double> ease);
    /// The user wants to remove one of their own cuts.
    void cutRemovalWanted(toile::CutId cut);
    void joinRemovalWanted(const std::string& name);

private:
    QWidget* makeHead(const ActionRegistry& actions);
    void makeTable();
    void onChanged(const DocumentChange& what);
    void showFreeEdges(bool shown);
    void updateHead();
    void fitColumns();
    void selectInTable();
    void selectInDocument();

    class Filter;

    Document& document_;
    SeamsModel* model_;
    Filter* sorted_;
    QTreeView* table_;
    QLabel *summary_, *empty_;
    QCheckBox* free_;
    QStackedWidget* pages_;       ///< the table, or why it is empty
    bool synchronizing_ = false;  ///< prevents recursion between the two selections
};

}  // namespace toile::app
