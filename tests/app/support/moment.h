// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/document/document.h"

namespace toile::test {

using namespace app;

/// A document at one moment: what was decided, and what was shown of it.
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

/// What was said of the reading, without what is known of earlier pieces.
inline LoadOptions typed(LoadOptions loading) {
    loading.known.clear();
    return loading;
}

/// Opens a garment alone: what else there is to say of it is as before.
void setGarment(Document& document, std::shared_ptr<const Garment> garment,
                std::shared_ptr<const Scene> scene = nullptr);
/// Shows these results as if they had been worked out.
void setResults(Document& document, PieceResults results, std::shared_ptr<const Scene> scene);
/// A step after which this is the garment, as if it had been worked out; nothing is flat.
void editGarment(Document& document, const QString& text, std::shared_ptr<const Garment> garment);
/// What has been said of a piece, to be said otherwise.
PieceSettings& said(DocumentState& state, const Document& document, int piece);

}  // namespace toile::test
