// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace toile::test {

/// A file of the shared garments, which stand beside the project and not in it.
std::filesystem::path sharedFile(const std::string& name);

/// A file or folder of this project's tree.
std::filesystem::path sourceFile(const std::string& name);

/// A file of our own where the name begins with "samples/", else a shared one. So one test states a
/// property of both, and the clone alone still has half of it.
std::filesystem::path dataFile(const std::string& name);

/// Whether it is one of the shared garments, none of which stand here.
bool mayBeMissing(const std::filesystem::path& path);

}  // namespace toile::test

/// Leaves the test, naming the file, where the shared data does not stand. Where it does and the
/// file is not in it, or where the file is our own, the test fails.
#define TOILE_NEEDS_SHARED(path)                                  \
    if (!std::filesystem::exists(path)) {                         \
        if (!toile::test::mayBeMissing(path)) {                   \
            FAIL() << "there is no " << (path);                   \
        }                                                         \
        GTEST_SKIP() << "needs the shared " << (path).filename(); \
    }
