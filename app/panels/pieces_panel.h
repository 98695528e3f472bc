// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/document/document_change.h"

class QLabel;
class QSortFilterProxyModel;
class QTreeView;

namespace toile {

class Document;
class PiecesModel;

/// Table of the pieces with their figures; beside it the selected piece in words. The table's
/// selection is the document's.
class PiecesPanel : public QWidget {
    Q_OBJECT

public:
    explicit PiecesPanel(Document& document, QWidget* parent = nullptr);

    QTreeView& table() { return *table_; }

signals:
    /// A piece was double-clicked or Enter pressed on it: it is to be shown.
    void activated();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeTable();
    /// Every column as wide as its contents; what is left goes to the status.
    void fitColumns();
    void fillWidth();
    void onChanged(DocumentChanges what);
    void selectInTable();
    void selectInDocument();
    void updateDetails();
    QString details(int piece) const;
    QString detailsOfMany() const;

    Document& document_;
    PiecesModel* model_;
    QSortFilterProxyModel* sorted_;
    QTreeView* table_;
    QLabel* details_;
    int statusWidth_ = 0;         ///< what its contents need, pixels
    bool synchronizing_ = false;  ///< keeps the two selections from answering each other
};

}  // namespace toile
