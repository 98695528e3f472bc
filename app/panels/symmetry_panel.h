// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/document/symmetry_facts.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QTreeWidget;

namespace toile::app {

class Document;
class DocumentChange;
class MirroredPiecesList;

/// Symmetry of the garment: how mirrored pieces are drawn, whether edits are mirrored, which pieces
/// mirror each other, and which seams have no counterpart.
class SymmetryPanel : public QWidget {
    Q_OBJECT

public:
    /// The document must outlive the panel.
    explicit SymmetryPanel(Document& document, QWidget* parent = nullptr);

    /// The field that takes the keyboard focus.
    QWidget& firstField() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeSettings();
    void makeSeamList();
    void onChanged(const DocumentChange& what);
    void refresh();
    void showFacts();
    void showSeams();
    void setMirror(int choice);
    void setHalf(int row, bool byHalf);
    /// Describes the mirror plane, or why there is none.
    QString planeText() const;
    /// How many pieces are drawn equal, and by how much that changes them.
    QString drawnText() const;

    Document& document_;
    QComboBox* mirror_;
    QCheckBox* edits_;
    QLabel *plane_, *drawn_;
    MirroredPiecesList* pieces_;
    QTreeWidget* seams_;  ///< without a counterpart
    SymmetryFacts facts_;
    bool fills_ = false;  ///< rows are changed by code, not by the user
    bool isStale_ = true;
};

}  // namespace toile::app
