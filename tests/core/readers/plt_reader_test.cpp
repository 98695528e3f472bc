// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/readers/plt_reader.h"

#include <string>

#include <gtest/gtest.h>

#include "core/formats/writers.h"
#include "tests/core/support/generator.h"

namespace toile {
namespace {

std::vector<PltLine> plotOf(std::string_view bytes) {
    const auto plot = readPlt(bytes);
    EXPECT_TRUE(plot) << bytes;
    return plot ? *plot : std::vector<PltLine>();
}

TEST(ReadPlt, AnySpellingOfALineIsTheSame) {
    Points2 expected(3, 2);
    expected << 1, 2, 11, 2, 11, 7;
    for (const char* bytes :
         {"IN;PA;SP2;PU40,80;PD440,80,440,280;PU;", "in;sp2;pu40,80;pd440,80;pd440,280;pu;",
          "SP2PU40 80PD440 80 440 280", "SP2;PA40,80;PD;PA440,80,440,280;PU",
          "SP2;PU40,80;PD;PR400,0,0,200;PA;PU;", "SP2;PU40,80;PR;PD400,0;PD0,200;",
          "\x1b.(;SP2;LBPD9,9\x03PU+40,80.0;PD440,80,\r\n440,280;",
          "\x1b%-12345X\x1b%0BSP2;PW0.3;LT;VS20;PU40,80;PD440,80,440,280;DT*;LBPU0*SP0;"}) {
        const auto plot = plotOf(bytes);
        ASSERT_EQ(plot.size(), 1U) << bytes;
        EXPECT_EQ(plot[0].pen, 2);
        EXPECT_FALSE(plot[0].closed);
        EXPECT_EQ(plot[0].points, expected) << bytes;
    }
}

TEST(ReadPlt, LineThatEndsWhereItBeganIsClosed) {
    const auto plot = plotOf("PU0,0;PD40,0,40,40,0,0;PU80,80;PD90,90,80,80;SP1PU0,0;PD1,1");
    ASSERT_EQ(plot.size(), 3U);
    EXPECT_TRUE(plot[0].closed);
    EXPECT_EQ(plot[0].points.rows(), 3);
    EXPECT_FALSE(plot[1].closed) << "there and back";
    EXPECT_EQ(plot[2].pen, 1);
}

TEST(ReadPlt, OtherFilesAreRefused) {
    for (const char* bytes : {"", "hello", "IN;SP1;", "IN;SC0,10,0,10;PU0,0;PD1,1;"}) {
        const auto plot = readPlt(bytes);
        ASSERT_FALSE(plot) << bytes;
        EXPECT_EQ(plot.error().code, ErrorCode::MalformedFile);
    }
}

TEST(ReadPlt, DamagedFilesDoNoHarm) {
    test::Generator random(77);
    const std::string drawing = writePlt(draw(Pattern{}, Marker{}));
    const std::string words = "\x1b.@;IN;DF;SP3;PU1,2;PD3,4;PR-5,6;LBx\x03;DT!;LBy!;PE<=>;SP9e9;";
    constexpr std::string_view kBytes = "0123456789.-+,; INPAUDRSLBTC\x1b\x03\x01\xff";
    for (int round = 0; round < 6000; ++round) {
        std::string bytes = round % 2 == 0 ? drawing : words;
        for (int k = random.whole(1, 6); k > 0; --k) {
            const auto at =
                static_cast<std::size_t>(random.whole(0, static_cast<int>(bytes.size()) - 1));
            const auto other =
                static_cast<std::size_t>(random.whole(0, static_cast<int>(kBytes.size()) - 1));
            if (random.chance(0.5)) {
                bytes[at] = kBytes[other];
            } else {
                bytes.insert(at, random.chance(0.5) ? std::string(1, kBytes[other])
                                                    : bytes.substr(at / 2, 12));
            }
        }
        if (const auto plot = readPlt(bytes)) {
            for (const PltLine& line : *plot) {
                ASSERT_TRUE(line.points.allFinite());
                ASSERT_GE(line.points.rows(), 2);
            }
        }
    }
}

}  // namespace
}  // namespace toile
