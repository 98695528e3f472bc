// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/text/overlay_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

#include "app/text/figures.h"

namespace toile::app {

namespace {

/// The context of the translations.
class OverlayText {
    Q_DECLARE_TR_FUNCTIONS(OverlayText)
};

QString withSign(Overlay overlay, double value, const QString& digits) {
    // What rounds to nothing has no sign.
    const bool isZero = QLocale().toDouble(digits) == 0;
    if (isZero || (value > 0 && !isSigned(overlay))) {
        return digits;
    }
    return (value < 0 ? QString(kMinus) : QString('+')) + digits;
}

}  // namespace

OverlayWords overlayWords(Overlay overlay) {
    switch (overlay) {
        case Overlay::None:
            return {OverlayText::tr("Piece colours"),
                    {},
                    OverlayText::tr("each piece in its own colour")};
        case Overlay::Checker:
            return {OverlayText::tr("Checkerboard"),
                    {},
                    OverlayText::tr("squares of 1 cm on the flat cloth")};
        case Overlay::Area:
            return {OverlayText::tr("Area change"), OverlayText::tr("%"),
                    OverlayText::tr("worn against flat: orange must stretch, blue has surplus")};
        case Overlay::Angle:
            return {OverlayText::tr("Angle change"), OverlayText::tr("°"),
                    OverlayText::tr("largest change of a corner, flat against worn")};
        case Overlay::Strain:
            return {OverlayText::tr("Edge strain"), OverlayText::tr("%"),
                    OverlayText::tr("what the cloth must do: orange stretches, blue has surplus")};
        case Overlay::Warp:
            return {OverlayText::tr("Strain along warp"), OverlayText::tr("%"),
                    OverlayText::tr("along the grain: orange stretches, blue has surplus")};
        case Overlay::Weft:
            return {OverlayText::tr("Strain along weft"), OverlayText::tr("%"),
                    OverlayText::tr("across the grain: orange stretches, blue has surplus")};
        case Overlay::Bias:
            return {OverlayText::tr("Strain on the bias"), OverlayText::tr("%"),
                    OverlayText::tr("at 45° to the grain, the worse of both diagonals")};
        case Overlay::Principal:
            return {OverlayText::tr("Principal strain"), OverlayText::tr("%"),
                    OverlayText::tr("arrows outwards stretch, arrows inwards have surplus")};
        case Overlay::Dirichlet:
            return {
                OverlayText::tr("Distortion energy"), OverlayText::tr("%"),
                OverlayText::tr("symmetric Dirichlet, above that of cloth that keeps its shape")};
    }
    return {};
}

QString overlayNumber(Overlay overlay, double value) {
    return withSign(overlay, value, QLocale().toString(std::abs(value), 'g', 4));
}

QString overlayValueText(Overlay overlay, double value) {
    const int decimals = overlay == Overlay::Dirichlet ? 2 : 1;
    const double size = std::abs(value);
    // A place at a torn triangle: digits after the point say nothing.
    const QString digits = QLocale().toString(size, 'f', size >= 1000 ? 0 : decimals);
    const QString number = withSign(overlay, value, digits);
    const QString unit = overlayWords(overlay).unit;
    // A narrow no-break space before the percent sign; none before degrees.
    return overlay == Overlay::Angle ? number + unit : number + QChar(0x202F) + unit;
}

}  // namespace toile::app
