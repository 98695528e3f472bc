// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>

#include "app/document/document_state.h"

namespace toile::app {

class Document;

/// One step of the history: exchanges the document's state for another, finished one, and so cannot
/// fail. Places that pieces are given afterwards become part of the state they were given for.
class StateStep : public QUndoCommand {
public:
    /// @param gesture  steps of one gesture, such as a drag, become one; -1: stands alone
    StateStep(Document& document, const QString& text, DocumentState next, int gesture);

    int id() const override { return gesture_; }
    void redo() override;
    void undo() override;
    bool mergeWith(const QUndoCommand* later) override;

private:
    Document& document_;
    DocumentState other_;   ///< to exchange the present one for
    bool wasFlat_ = false;  ///< all of it, once
    int gesture_;
};

}  // namespace toile::app
