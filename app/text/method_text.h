// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/flatten/base/method.h"

namespace toile::app {

// lupdate is told of this name, and takes the namespace for the context.
#define TR(text) text

/// How a method is called in the window, untranslated, with a mark before the letter that chooses
/// it in the menu; `methodName` (figures.h) is what a person reads elsewhere.
constexpr const char* methodText(Method method) {
    switch (method) {
        case Method::Isometric:
            return TR("Least &distortion");
        case Method::Curvature:
            return TR("Angles follow the c&urvature");
        case Method::Wang2005:
            return TR("Angles spread &evenly (Wang 2005)");
        case Method::Stretch:
            return TR("Least &stretch on a circle (Yoshizawa 2004)");
        case Method::Natural:
            return TR("&Free outline (Desbrun 2002)");
        case Method::Lscm:
            return TR("Free outline, least squares (Lé&vy 2002)");
        case Method::Abf:
            return TR("Free outline, by an&gles (Sheffer 2005)");
        case Method::Convex:
            return TR("On a ci&rcle (Floater 2003)");
    }
    return "";
}

#undef TR

}  // namespace toile::app
