// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFlags>

namespace toile {

/// What a change of the document is about; views redraw only what they show of it.
enum class DocumentChange : unsigned {
    Garment = 1U << 0,        ///< another garment: pieces, names, everything below
    Results = 1U << 1,        ///< flat pieces, their figures and the scene made of them
    Selection = 1U << 2,      ///< which pieces are selected
    Options = 1U << 3,        ///< how pieces are to be flattened; results follow later
    View = 1U << 4,           ///< what is painted: overlay, wireframe, designer's outline
    Seams = 1U << 5,          ///< the ease that seams are meant to have; pieces and results stay
    SeamSelection = 1U << 6,  ///< which seam is selected
};

Q_DECLARE_FLAGS(DocumentChanges, DocumentChange)
Q_DECLARE_OPERATORS_FOR_FLAGS(DocumentChanges)

}  // namespace toile
