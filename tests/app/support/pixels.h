// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>

namespace toile::test {

/// How many pixels have a colour, to within this many steps of 255 in each channel.
int countPixels(const QImage& image, const QColor& colour, int tolerance);

}  // namespace toile::test
