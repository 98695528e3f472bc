// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/shared_data.h"

namespace toile::test {

std::filesystem::path sharedFile(const char* name) {
    return std::filesystem::path(TOILE_SHARED_DATA) / name;
}

}  // namespace toile::test
