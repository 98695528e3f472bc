// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QScrollArea;
class QWidget;

namespace toile::app {

/// Where there is too little room the contents scroll, so that they ask for none of the window's.

/// Scrolls up and down. The bar has its room from the beginning: nothing moves or is covered when
/// it comes.
QScrollArea* scrolledColumn(QWidget& contents, QWidget* parent);
/// Scrolls to the sides.
QScrollArea* scrolledRow(QWidget& contents, QWidget* parent);

}  // namespace toile::app
