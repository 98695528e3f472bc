// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <gtest/gtest.h>

#include "core/base/id.h"

namespace toile {
namespace {

TEST(ContentHash, IsXxh64AsPublished) {
    EXPECT_EQ(contentHash(""), 0xEF46DB3751D8E999U);
    EXPECT_EQ(contentHash("a"), 0xD24EC4F1A98C6E5BU);
    EXPECT_EQ(contentHash("abc"), 0x44BC2CF5AD770999U);
    EXPECT_EQ(contentHash("Nobody inspects the spammish repetition"), 0xFBCEA83C8A378BF1U);
}

TEST(ContentHash, EveryByteAndEveryLengthCounts) {
    std::set<std::uint64_t> seen;
    std::string bytes;
    for (int length = 0; length < 100; ++length, bytes += 'x') {
        EXPECT_TRUE(seen.insert(contentHash(bytes)).second);
        for (int at = 0; at < length; ++at) {
            std::string other = bytes;
            other[static_cast<std::size_t>(at)] = 'y';
            EXPECT_TRUE(seen.insert(contentHash(other)).second) << length << " at " << at;
        }
    }
}

TEST(ContentHash, TheTextReadsBack) {
    for (const std::uint64_t hash : {std::uint64_t{0}, std::uint64_t{0xF}, contentHash("abc")}) {
        EXPECT_EQ(parseHash(hashText(hash)), hash);
    }
    EXPECT_EQ(hashText(0xF), "xxh64:000000000000000f");
    for (const char* other : {"", "xxh64:", "xxh64:12", "md5:000000000000000f",
                              "xxh64:00000000000000 f", "xxh64:000000000000000g"}) {
        EXPECT_EQ(parseHash(other), std::nullopt) << other;
    }
}

}  // namespace
}  // namespace toile
