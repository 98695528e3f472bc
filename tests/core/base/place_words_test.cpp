// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/wording.h"

namespace toile {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

Error crossing(Wording detail) {
    return {ErrorCode::OutlineCrosses, Subject::piece("(1.0, 2.0, 3.0) mm"), std::move(detail)};
}

TEST(PlaceWords, AreThoseOfTheSentenceInTheirOrder) {
    const Wording where = worded("%2 and %1 mm on the piece meet",
                                 {placeWording(1, 2, 3), placeWording(-0.04, 5e-3, 1234.56)});
    const auto places = placesIn(crossing(worded("%1, 2 mm; %2", {figure(2), where})));
    ASSERT_EQ(places.size(), 2U);
    EXPECT_EQ(places[0].words, "(0.0, 0.0, 1234.6)");
    EXPECT_EQ(places[0].at, (std::array<double, 3>{0, 0, 1234.56}));
    EXPECT_EQ(places[1].words, "(1.0, 2.0, 3.0) mm");
    EXPECT_EQ(places[1].at, (std::array<double, 3>{1, 2, 3}));
}

TEST(PlaceWords, MayStandWithoutBrackets) {
    Wording said = worded("1 vertex");
    said += worded(", at ");
    said += worded("%1 mm", {barePlaceWording(1e300, -2, 0.25)});
    EXPECT_EQ(said, "1 vertex, at 1.00e+300, -2.0, 0.2 mm");
    const auto places = placesIn(crossing(said));
    ASSERT_EQ(places.size(), 1U);
    EXPECT_EQ(places[0].words, "1.00e+300, -2.0, 0.2 mm");
    EXPECT_EQ(places[0].at, (std::array<double, 3>{1e300, -2, 0.25}));
}

TEST(PlaceWords, AreOfTheGarmentAndNumbers) {
    for (const Wording& none :
         {Wording("at (1.0, 2.0, 3.0) mm"), worded("(%1, %2)", {figure(1), figure(2)}),
          worded("%1, %2, %3", {"front", "back", "sleeve"}), placeWording(0, kNowhere, 0),
          Wording()}) {
        EXPECT_TRUE(placesIn(crossing(none)).empty()) << none;
    }
}

TEST(PlaceWords, StandInTheSentenceHoweverLongItIs) {
    Wording said;
    for (int i = 0; i < 100; ++i) {
        said += worded("%1 mm; ", {placeWording(i, 0, 0)});
    }
    const Error error = crossing(said);
    const std::string sentenceOf = sentence(error);
    const auto places = placesIn(error);
    EXPECT_GT(places.size(), 10U);
    EXPECT_LT(places.size(), 100U);
    std::size_t end = std::string::npos;
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
        const std::size_t at = sentenceOf.rfind(place->words, end);
        ASSERT_NE(at, std::string::npos);
        end = at - 1;
    }
}

}  // namespace
}  // namespace toile
