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

/// The cuts and joins that were made before flattening: what, by whom, how long. Delete takes back
/// one of the user's. Hides itself where there are none.
class CutsPanel : public QWidget {
    Q_OBJECT

public:
    explicit CutsPanel(const Document& document, QWidget* parent = nullptr);

signals:
    /// A person has selected a cut: this seam is of it.
    void seamChosen(int seam);
    /// A cut of the user's is to be taken back.
    void removeWanted(toile::CutId cut);
    /// A seam that was joined is to be there again.
    void joinRemovalWanted(const std::string& name);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void onChanged(const DocumentChange& what);
    void rebuild();
    void removeCurrent();
    /// Selects the cut whose seam is selected, and else none.
    void selectInTable();
    void tellSeam();

    const Document& document_;
    QLabel* count_;
    QTreeWidget* table_;
    bool synchronizing_ = false;  ///< keeps the two selections from answering each other
};

}  // namespace toile::app
