// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/piece_choice.h"

#include <QSignalBlocker>

namespace toile::app {

PieceChoice::PieceChoice(QWidget* parent) : QComboBox(parent) {
    setAccessibleName(tr("Pieces"));
    setToolTip(tr("Which pieces are wanted"));
    hide();
    connect(this, &QComboBox::currentIndexChanged, this, &PieceChoice::chosen);
}

void PieceChoice::offer(int selected, bool chosen) {
    const QSignalBlocker quiet(this);
    clear();
    addItems({tr("All pieces"), tr("Selected pieces (%1)").arg(selected)});
    setCurrentIndex(chosen && selected > 0 ? 1 : 0);
    setVisible(selected > 0);
}

}  // namespace toile::app
