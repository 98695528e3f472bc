// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/resources.h"

#include <QtGlobal>

// The macro declares a function and has to stand outside of any namespace.
static void registerResources() {
    Q_INIT_RESOURCE(toile);
    Q_INIT_RESOURCE(translations);
}

namespace toile {

void loadResources() {
    registerResources();
}

}  // namespace toile
