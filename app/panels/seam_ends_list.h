// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>

#include "app/document/line_facts.h"

namespace toile::app {

class Document;

/// The ends of seams where lines are to run on into each other, the largest kink first: a check
/// box each for whether the kink is taken out.
class SeamEndsList : public QTreeWidget {
    Q_OBJECT

public:
    enum Column { Name, End, Kink, Kept, ColumnCount };

    explicit SeamEndsList(QWidget* parent = nullptr);

    void show(const Document& document, const LineFacts& facts);
    /// Selects the rows of a seam, or none.
    void select(std::optional<int> seam);

signals:
    /// @param end  its place in LineFacts::ends
    void trueingWanted(int end, bool trued);
    /// A person has chosen a row of this seam.
    void seamChosen(int seam);

private:
    bool fills_ = false;  ///< not a person
};

}  // namespace toile::app
