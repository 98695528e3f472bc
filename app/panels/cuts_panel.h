// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <string>

#include "core/base/id.h"

class QLabel;
class QTreeWidget;

namespace toile::app {

class Document;
class DocumentChange;

/// The cuts and joins made before flattening: name, author and length. Delete removes one of the
/// user's. Hidden if there are none.
class CutsPanel : public QWidget {
    Q_OBJECT

public:
    explicit CutsPanel(const Document& document, QWidget* parent = nullptr);

signals:
    /// The user selected a cut; `seam` belongs to it.
    void seamChosen(int seam);
    /// The user wants to remove one of their own cuts.
    void removeWanted(toile::CutId cut);
    /// The user wants to restore a seam that was joined.
    void joinRemovalWanted(const std::string& name);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void onChanged(const DocumentChange& what);
    void rebuild();
    void removeCurrent();
    /// Selects the cut of the selected seam, or nothing.
    void selectInTable();
    void tellSeam();

    const Document& document_;
    QLabel* count_;
    QTreeWidget* table_;
    bool synchronizing_ = false;  ///< prevents recursion between the two selections
};

}  // namespace toile::app
