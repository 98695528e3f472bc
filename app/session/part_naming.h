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

/// Gives the parts of a cut piece the names that a proposal has for them, when they exist, in the
/// same step of the history as the cuts. GUI thread only.
class PartNaming : public QObject {
public:
    explicit PartNaming(Document& document);

    /// @param nameOf   name of a part in the words of the core; null: unknown
    /// @param gesture  of the step (Document::edit)
    void await(PieceId whole, std::function<std::string(const Piece&)> nameOf, int gesture);

private:
    void nameParts();

    Document& document_;
    PieceId whole_{};
    std::function<std::string(const Piece&)> nameOf_;  ///< null if no parts are awaited
    int gesture_ = -1;
};

}  // namespace toile::app
