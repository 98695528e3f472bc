// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/progress.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

TEST(Progress, GoesFromNothingToAll) {
    Progress progress;
    progress.start(4);
    EXPECT_EQ(progress.fraction(), 0);
    progress.advance(1);
    EXPECT_EQ(progress.fraction(), 0.25);
    progress.advance(3);
    EXPECT_EQ(progress.fraction(), 1);
}

TEST(Progress, PartsOfALongerTaskFollowEachOther) {
    Progress progress;
    progress.setShare(0, 0.75);
    EXPECT_EQ(progress.fraction(), 0);
    progress.start(3);
    progress.advance(2);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.5);
    progress.advance(1);
    progress.setShare(0.75, 1);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.75);
    progress.start(10);
    EXPECT_DOUBLE_EQ(progress.fraction(), 0.75);
    progress.advance(10);
    EXPECT_DOUBLE_EQ(progress.fraction(), 1);
}

}  // namespace
}  // namespace toile
