// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/wording.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace toile {
namespace {

TEST(Wording, IsItsEnglishText) {
    EXPECT_EQ(worded("%1 of %2 (%3 % each)", {figure(3), "sleeve %1", figure(-0.04, 1)}),
              "3 of sleeve %1 (0.0 % each)");
    EXPECT_EQ(countWording(1, "vertex"), "1 vertex");
    EXPECT_EQ(countWording(1234, "vertex"), "1234 vertices");
    EXPECT_EQ(countWording(2, "needle"), "2 needles");
    EXPECT_EQ(figure(123456789012.25, 1), "123456789012.2");
    EXPECT_EQ(figure(-5.77350269e300, 1), "-5.77e+300");
    EXPECT_EQ(figure(-5.77350269e300, 1).decimals(), -1);
    EXPECT_EQ(placeWording(1, -2.5, 0), "(1.0, -2.5, 0.0)");
    const Error error{ErrorCode::CutImpossible, Subject::cut("dart"), worded("it has no points")};
    EXPECT_NE(sentence(error).find("dart: the cut cannot be made (it has no points)"),
              std::string::npos);
}

TEST(Wording, KnowsWhatItIsMadeOf) {
    const Wording said = worded("%1 at %2 mm", {countWording(2, "edge"), placeWording(1, 2, 3)});
    EXPECT_STREQ(said.pattern(), "%1 at %2 mm");
    ASSERT_EQ(said.arguments().size(), 2u);
    EXPECT_STREQ(said.arguments()[0].pattern(), "%1 edges");
    EXPECT_EQ(said.arguments()[0].arguments()[0].value(), 2);
    EXPECT_EQ(Wording("as it stands").pattern(), nullptr);
    EXPECT_EQ(Wording("as it stands").decimals(), -1);
}

TEST(Wording, GrowsByWhatIsAdded) {
    Wording said;
    said += worded("no piece has an edge");
    EXPECT_STREQ(said.pattern(), "no piece has an edge");
    said += "";
    EXPECT_STREQ(said.pattern(), "no piece has an edge");
    said += "; ";
    said += figure(1.5, 1);
    EXPECT_EQ(said, "no piece has an edge; 1.5");
    EXPECT_EQ(said.arguments().size(), 2u);
}

}  // namespace
}  // namespace toile
