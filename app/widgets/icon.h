// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>

namespace toile::app {

/// Icon from resources/icons, whose `currentColor` is the palette's text colour when it is painted.
/// So it is legible in both themes and follows a change. Fainter when disabled.
/// @param colour  used instead of the palette's, if valid
QIcon themedIcon(const QString& name, const QColor& colour = {});

}  // namespace toile::app
