// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <tuple>

#include <gtest/gtest.h>

#ifdef __linux__
#include <csignal>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>
#endif

#include "core/base/id.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

int entriesIn(const fs::path& folder) {
    int entries = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder)) {
        ++entries;
    }
    return entries;
}

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
    EXPECT_EQ(entriesIn(folder / ""), 2);
}

TEST(File, KeepsLinksAndPermissions) {
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

TEST(File, IsMadeWhereALinkLeads) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "deep");
    fs::create_symlink("deep/second.txt", folder / "link.txt");
    fs::create_symlink(folder / "deep" / "real.txt", folder / "deep" / "second.txt");
    ASSERT_TRUE(writeFile(folder / "link.txt", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
    EXPECT_TRUE(fs::is_symlink(folder / "deep" / "second.txt"));
    EXPECT_EQ(folder.read("deep/real.txt"), "new");
    fs::create_symlink("round.txt", folder / "round.txt");
    EXPECT_FALSE(writeFile(folder / "round.txt", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "round.txt"));
}

TEST(File, TakesEveryNameThatTheSystemTakes) {
    const test::TemporaryFolder folder;
    for (const std::size_t length : {1U, 240U, 241U, 255U}) {
        const std::string name(length, 'n');
        const auto written = writeFile(folder / name, "text");
        ASSERT_TRUE(written) << length << ": " << sentence(written.error());
        EXPECT_EQ(folder.read(name), "text");
    }
    EXPECT_FALSE(writeFile(folder / std::string(256, 'n'), "text"));
    EXPECT_EQ(entriesIn(folder / ""), 4);
}

TEST(File, WithoutEndOrBeyondMemoryIsASentence) {
    const test::TemporaryFolder folder;
    std::ofstream(folder / "huge.obj").put('v');
    fs::resize_file(folder / "huge.obj", std::uintmax_t{200} << 30);  // takes no room on the disk
    const auto huge = readFile(folder / "huge.obj");
    ASSERT_FALSE(huge);
    EXPECT_EQ(huge.error().code, ErrorCode::FileUnreadable);
    EXPECT_EQ(huge.error().detail, "it is longer than 2 GiB");
}

#ifdef __linux__

/// Does it as a person who may not do everything, in a process of its own.
template <class Do>
void asSomebody(const Do& act) {
    const auto actAndEnd = [&act] {
        const bool changed = ::geteuid() != 0 || (::setegid(65534) == 0 && ::seteuid(65534) == 0);
        std::_Exit(changed && act() ? 0 : 1);
    };
    EXPECT_EXIT(actAndEnd(), testing::ExitedWithCode(0), "");
}

TEST(FileDeathTest, LeavesNothingBehindWhenItsProcessIsKilled) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "x.txt", "old"));
    const auto beKilledHalfWay = [&folder] {
        const rlimit none{0, 0}, little{1000, 1000};
        ::setrlimit(RLIMIT_CORE, &none);
        ::setrlimit(RLIMIT_FSIZE, &little);
        std::ignore = writeFile(folder / "x.txt", std::string(100000, 'n'));
    };
    EXPECT_EXIT(beKilledHalfWay(), testing::KilledBySignal(SIGXFSZ), "");
    EXPECT_EQ(entriesIn(folder / ""), 1);
    EXPECT_EQ(folder.read("x.txt"), "old");
}

TEST(File, ClearsWhatAKilledWriterHasLeft) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "x.txt", "old"));
    const std::string prefix = ".toile-" + std::to_string(contentHash("x.txt")) + "-";
    for (const std::string& name : {prefix + "1", prefix + "2", std::string(".toile-5-1")}) {
        std::ofstream(folder / name) << "half";
    }
    const int held = ::open((folder / (prefix + "2")).c_str(), O_RDONLY);
    ASSERT_EQ(::flock(held, LOCK_EX), 0);  // of another writer at work
    ASSERT_TRUE(writeFile(folder / "x.txt", "new"));
    EXPECT_FALSE(fs::exists(folder / (prefix + "1")));
    EXPECT_TRUE(fs::exists(folder / (prefix + "2")));
    EXPECT_TRUE(fs::exists(folder / ".toile-5-1"));  // of another file
    ::close(held);
    ASSERT_TRUE(writeFile(folder / "x.txt", "newer"));
    EXPECT_EQ(entriesIn(folder / ""), 2);
}

TEST(FileDeathTest, IsWrittenInAFolderThatLetsNothingBeMade) {
    const test::TemporaryFolder folder;
    fs::create_directory(folder / "shut");
    ASSERT_TRUE(writeFile(folder / "shut" / "x.txt", "old"));
    fs::permissions(folder / "shut" / "x.txt", fs::perms(0666));
    fs::permissions(folder / "shut", fs::perms(0555));
    asSomebody([&]() -> bool {
        return writeFile(folder / "shut" / "x.txt", "new").ok() &&
               !writeFile(folder / "shut" / "y.txt", "new").ok();
    });
    EXPECT_EQ(folder.read("shut/x.txt"), "new");
    EXPECT_EQ(entriesIn(folder / "shut"), 1);
    fs::permissions(folder / "shut", fs::perms(0755));
}

TEST(FileDeathTest, StaysItsOwners) {
    if (::geteuid() != 0) {
        GTEST_SKIP() << "only root gives files to others";
    }
    const test::TemporaryFolder folder;
    fs::permissions(folder / "", fs::perms(0777));
    const auto ownerOf = [&](const char* name) -> uid_t {
        struct stat is;
        return ::stat((folder / name).c_str(), &is) == 0 ? is.st_uid : 0;
    };
    for (const char* name : {"ours.txt", "theirs.txt"}) {
        folder.write(name, "old");
        fs::permissions(folder / name, fs::perms(0666));
        ASSERT_EQ(::chown((folder / name).c_str(), 1234, 1234), 0);
    }
    ASSERT_TRUE(writeFile(folder / "ours.txt", "new"));  // root makes it anew and gives it back
    asSomebody([&]() -> bool { return writeFile(folder / "theirs.txt", "new").ok(); });
    for (const char* name : {"ours.txt", "theirs.txt"}) {
        EXPECT_EQ(ownerOf(name), 1234U) << name;
        EXPECT_EQ(folder.read(name), "new") << name;
    }
}

TEST(File, KeepsItsAccessList) {
    const test::TemporaryFolder folder;
    ASSERT_TRUE(writeFile(folder / "x.txt", "old"));
    constexpr auto kName = "system.posix_acl_access";
    // Version 2; then tag, permissions and id of each entry: owner, user 1234, group, mask, others.
    const std::uint16_t list[] = {2,      0,      1,  6, 0xFFFF, 0xFFFF, 2,  6, 1234,   0,     4, 4,
                                  0xFFFF, 0xFFFF, 16, 6, 0xFFFF, 0xFFFF, 32, 4, 0xFFFF, 0xFFFF};
    const fs::path path = folder / "x.txt";
    if (::setxattr(path.c_str(), kName, list, sizeof list, 0) != 0) {
        GTEST_SKIP() << "the file system has no access lists";
    }
    ASSERT_TRUE(writeFile(path, "new"));
    std::uint16_t kept[std::size(list)] = {};
    ASSERT_EQ(::getxattr(path.c_str(), kName, kept, sizeof kept),
              static_cast<ssize_t>(sizeof list));
    EXPECT_TRUE(std::ranges::equal(list, kept));
}

#endif

TEST(File, SaysWhyItCannotBeRead) {
    const test::TemporaryFolder folder;
    const auto missing = readFile(folder / "none");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::FileUnreadable);
    EXPECT_EQ(readFile(folder / "").error().detail, "it is a folder");
#ifdef __linux__
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", folder / "device");
    for (const char* name : {"pipe", "device"}) {  // without waiting for who writes to it
        const auto odd = readFile(folder / name);
        ASSERT_FALSE(odd);
        EXPECT_EQ(odd.error().detail, "it is a pipe or a device; save it as a file first");
    }
#endif
}

}  // namespace
}  // namespace toile
