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

/// The garment as its own mirror image: what becomes of mirrored pieces, whether edits are mirrored
/// too, which pieces mirror each other and what has no counterpart.
class SymmetryPanel : public QWidget {
    Q_OBJECT

public:
    /// The document must outlive the panel.
    explicit SymmetryPanel(Document& document, QWidget* parent = nullptr);

    /// Where the keyboard goes.
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
    /// What is known of the mirror plane, or why nothing is.
    QString planeText() const;
    /// What comes of pieces that are drawn equal.
    QString drawnText() const;

    Document& document_;
    QComboBox* mirror_;
    QCheckBox* edits_;
    QLabel *plane_, *drawn_;
    MirroredPiecesList* pieces_;
    QTreeWidget* seams_;  ///< without a counterpart
    SymmetryFacts facts_;
    bool fills_ = false;  ///< not a person
    bool isStale_ = true;
};

}  // namespace toile::app
