// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include <gtest/gtest.h>

namespace toile::test {

/// A file of the shared garments, which stand beside the project and not in it.
std::filesystem::path sharedFile(const char* name);

}  // namespace toile::test

/// Leaves the test, naming the file, where the shared data does not stand.
#define TOILE_NEEDS_SHARED(path)                                \
    if (!std::filesystem::exists(path)) {                       \
        GTEST_SKIP() << "needs " << (path).filename().string(); \
    }
