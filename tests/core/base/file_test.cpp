// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"

#include <gtest/gtest.h>

#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

TEST(File, WhatIsWrittenReadsBack) {
    const test::TemporaryFolder folder;
    const std::string bytes("a\0b\r\n\xFF", 6);
    ASSERT_TRUE(writeFile(folder / "x.bin", bytes));
    ASSERT_TRUE(writeFile(folder / "x.bin", bytes + bytes));  // replaces
    const auto read = readFile(folder / "x.bin");
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, bytes + bytes);
}

TEST(File, LeavesNothingBesideTheTarget) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "x.txt", "text"));
    EXPECT_FALSE(writeFile(folder / "missing" / "x.txt", "text"));
    std::filesystem::create_directory(folder / "taken");
    std::filesystem::create_directory(folder / "taken" / "full");
    EXPECT_FALSE(writeFile(folder / "taken", "text"));  // a folder of that name stands there
    int entries = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder / "")) {
        ++entries;
    }
    EXPECT_EQ(entries, 2);
}

TEST(File, KeepsLinksAndPermissions) {
    namespace fs = std::filesystem;
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "real.txt", "old"));
    fs::permissions(folder / "real.txt", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("real.txt", folder / "link.txt");
    ASSERT_TRUE(writeFile(folder / "link.txt", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
    EXPECT_EQ(folder.read("real.txt"), "new");
    EXPECT_EQ(fs::status(folder / "real.txt").permissions(),
              fs::perms::owner_read | fs::perms::owner_write);
}

TEST(File, SaysWhyItCannotBeRead) {
    const test::TemporaryFolder folder;
    const auto missing = readFile(folder / "none");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::FileUnreadable);
    EXPECT_EQ(readFile(folder / "").error().detail, "it is a folder");
}

}  // namespace
}  // namespace toile
