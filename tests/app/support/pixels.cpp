// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/pixels.h"

#include <cstdlib>

namespace toile::test {

int countPixels(const QImage& image, const QColor& colour, int tolerance) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            count += std::abs(qRed(pixel) - colour.red()) <= tolerance &&
                     std::abs(qGreen(pixel) - colour.green()) <= tolerance &&
                     std::abs(qBlue(pixel) - colour.blue()) <= tolerance;
        }
    }
    return count;
}

}  // namespace toile::test
