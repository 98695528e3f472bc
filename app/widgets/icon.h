// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>

namespace toile::app {

/// An icon of resources/icons whose `currentColor` is the palette's text colour at the time it is
/// painted, so that it is legible on light and dark and follows a change; fainter when disabled.
/// @param colour used instead of the palette's where valid
QIcon themedIcon(const QString& name, const QColor& colour = {});

}  // namespace toile::app
