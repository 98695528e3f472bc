// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/document/document_change.h"
#include "app/document/line_facts.h"

class QLabel;

namespace toile::app {

class ActionRegistry;
class DartForm;
class Document;
class PieceForm;
class PositionForm;
class SegmentForm;

/// Properties of the selection: of the garment if nothing is selected, of pieces with their
/// position, or of a segment with its seam or dart. Segments are computed only while one is shown.
class SelectionPanel : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the panel.
    SelectionPanel(Document& document, const ActionRegistry& actions, QWidget* parent = nullptr);

    /// The field that takes the keyboard focus for placing pieces.
    QWidget& placeField() const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeGarmentPage();
    QWidget* makePiecePage();
    QWidget* makeEdgePage();
    void onChanged(const DocumentChange& what);
    void refresh();
    void showPage(QWidget& shown);
    void showEdge();

    Document& document_;
    QLabel* summary_;
    PieceForm* piece_;
    PositionForm* position_;
    DartForm* dart_;
    SegmentForm* segment_;
    QWidget *garmentPage_, *piecePage_, *edgePage_;
    LineFacts facts_;  ///< while the edge page is shown
    bool isStale_ = true;
};

}  // namespace toile::app
