// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/version.h"

namespace toile {

std::string_view version() {
    return TOILE_VERSION;
}

}  // namespace toile
