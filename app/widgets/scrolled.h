// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QScrollArea;
class QWidget;

namespace toile::app {

/// Contents that scroll if space is short, so that they do not enlarge the window's minimum size.

/// Scrolls vertically. Space for the scroll bar is reserved, so that nothing moves or is covered
/// when it appears.
QScrollArea* scrolledColumn(QWidget& contents, QWidget* parent);
/// Scrolls horizontally.
QScrollArea* scrolledRow(QWidget& contents, QWidget* parent);

}  // namespace toile::app
