// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>

#include "app/document/line_facts.h"

namespace toile::app {

class Document;

/// Lists seam ends where lines should continue smoothly, largest kink first. A check box per row
/// removes the kink.
class SeamEndsList : public QTreeWidget {
    Q_OBJECT

public:
    enum Column { Name, End, Kink, Kept, ColumnCount };

    explicit SeamEndsList(QWidget* parent = nullptr);

    void show(const Document& document, const LineFacts& facts);
    /// Selects the rows of a seam, or none.
    void select(std::optional<int> seam);

signals:
    /// @param end  index into LineFacts::ends
    void trueingWanted(int end, bool trued);
    /// The user selected a row of this seam.
    void seamChosen(int seam);

private:
    bool fills_ = false;  ///< rows are changed by code, not by the user
};

}  // namespace toile::app
