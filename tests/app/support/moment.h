// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/document/document.h"

namespace toile::test {

using namespace app;

/// A document at one moment: the user's decisions, and everything derived from them.
struct Moment {
    DocumentState state{};
    Derived derived{};

    bool operator==(const Moment&) const = default;
};

inline Moment momentOf(const Document& document) {
    return {document.state(), document.derived()};
}

inline void open(Document& document, const Moment& moment) {
    document.open(moment.state, moment.derived);
}

/// The load options that the user set, without the known earlier pieces.
inline LoadOptions typed(LoadOptions loading) {
    loading.known.clear();
    return loading;
}

/// Opens a garment alone. Options, fabric and load options stay; everything else is reset.
void setGarment(Document& document, std::shared_ptr<const Garment> garment,
                std::shared_ptr<const Scene> scene = nullptr);
/// Shows these results as if they had been computed.
void setResults(Document& document, PieceResults results, std::shared_ptr<const Scene> scene);
/// Adds an undo step that changes the garment, as if it had been computed; nothing is flat.
void editGarment(Document& document, const QString& text, std::shared_ptr<const Garment> garment);
/// The settings of a piece in `state`, copied from the document, to be changed.
PieceSettings& said(DocumentState& state, const Document& document, int piece);

}  // namespace toile::test
