// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFlags>

namespace toile::app {

/// What a change of the document is about; views redraw only what they show of it.
enum class DocumentChange : unsigned {
    Opened = 1U << 0,         ///< another document: everything below, and no history
    Garment = 1U << 1,        ///< other pieces or names
    Results = 1U << 2,        ///< flat pieces, their figures and the scene made of them
    Selection = 1U << 3,      ///< which pieces are selected
    Options = 1U << 4,        ///< how pieces are to be flattened; results follow later
    View = 1U << 5,           ///< what is painted: overlay, wireframe, designer's outline
    Seams = 1U << 6,          ///< the ease or the names of seams; pieces and results stay
    SeamSelection = 1U << 7,  ///< which seam is selected
    Loading = 1U << 8,        ///< how files are read, divided and cut
    Fabric = 1U << 9,         ///< what the garment is cut from
    Settings = 1U << 10,      ///< of pieces: name, place, grain, quantity
    Reference = 1U << 11,     ///< the reference pattern, and how it lies on the pieces
    Marker = 1U << 12,        ///< what has been said of laying the pattern on cloth
    Proof = 1U << 13,         ///< the pattern sewn back together, or on its way there
    ProofPlan = 1U << 14,     ///< what has been said of how it is sewn
    Mark = 1U << 16,          ///< which stretch of an outline or vertex is selected
    Hover = 1U << 17,         ///< what the pointer is on
};

Q_DECLARE_FLAGS(DocumentChanges, DocumentChange)
Q_DECLARE_OPERATORS_FOR_FLAGS(DocumentChanges)

}  // namespace toile::app
