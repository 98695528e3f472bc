// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace toile::app {

/// Whether all pieces are wanted on paper or in a file, or those that are selected.
class PieceChoice : public QComboBox {
    Q_OBJECT

public:
    /// Hidden until there is a choice.
    explicit PieceChoice(QWidget* parent);

    /// With none selected there is no choice. @param chosen  these, at first
    void offer(int selected, bool chosen);
    bool isSelectedOnly() const { return currentIndex() == 1; }

signals:
    void chosen();
};

}  // namespace toile::app
