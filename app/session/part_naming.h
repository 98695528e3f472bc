// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <string>

#include "core/base/id.h"

namespace toile {
struct Piece;
}  // namespace toile

namespace toile::app {

class Document;

/// Calls the parts of a piece what a proposal has for them once they are there, in the same step of
/// the history as the cuts that they come of. GUI thread only.
class PartNaming : public QObject {
public:
    explicit PartNaming(Document& document);

    /// @param nameOf   of a part, in the words of the core; null: nothing is known
    /// @param gesture  of the step (Document::edit)
    void await(PieceId whole, std::function<std::string(const Piece&)> nameOf, int gesture);

private:
    void nameParts();

    Document& document_;
    PieceId whole_{};
    std::function<std::string(const Piece&)> nameOf_;  ///< null where none is awaited
    int gesture_ = -1;
};

}  // namespace toile::app
