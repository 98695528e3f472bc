// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/document/document_change.h"

namespace toile::app {

class ActionRegistry;
class Document;
class PieceForm;
class PositionForm;

/// What can be said and typed about the selected pieces: what they are, and where they lie. Nothing
/// moves whatever is selected; what makes no sense is grey.
class PiecePanel : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the panel.
    PiecePanel(Document& document, const ActionRegistry& actions, QWidget* parent = nullptr);

    /// Where the keyboard goes that wants to place pieces.
    QWidget& placeField() const;

private:
    void onChanged(DocumentChanges what);

    PieceForm* piece_;
    PositionForm* position_;
};

}  // namespace toile::app
