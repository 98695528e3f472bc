// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/reference.h"

#include <algorithm>

namespace toile::app {

bool isSure(const PieceMatch& pair) {
    return pair.rivals.empty() && !pair.lines.empty() && pair.lines.front().fit.laid.rows() > 0;
}

const PieceMatch* pairOf(const PatternMatch& match, int piece) {
    const auto found = std::ranges::lower_bound(match.pairs, piece, {}, &PieceMatch::piece);
    return found == match.pairs.end() || found->piece != piece ? nullptr : &*found;
}

}  // namespace toile::app
