// SPDX-License-Identifier: GPL-3.0-or-later
// What other programs make of our PDF files. Each test needs one, and is skipped where it is
// absent.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <sstream>

#include <gtest/gtest.h>

#include "core/formats/pdf/pdf_writer.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

/// What a program says; empty where it fails.
std::string saidBy(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>&1").c_str(), "r"),
                                                     pclose);
    std::string said;
    for (int c = 0; pipe && (c = std::fgetc(pipe.get())) != EOF;) {
        said += static_cast<char>(c);
    }
    return said;
}

#define TOILE_NEEDS_PROGRAM(name)                  \
    if (saidBy("command -v " name).empty()) {      \
        GTEST_SKIP() << "needs the program " name; \
    }

class PdfViewers : public testing::TestWithParam<Paper> {
protected:
    PdfViewers() {
        const Pattern pattern = test::sewingPattern();
        const auto bytes = writePdf(draw(pattern, placeCopies(pattern)), pattern, {GetParam(), 10});
        EXPECT_TRUE(bytes);
        file_ = "'" + folder_.write("out.pdf", *bytes).string() + "'";
    }

    test::TemporaryFolder folder_;
    std::string file_;
};

TEST_P(PdfViewers, QpdfFindsNoFault) {
    TOILE_NEEDS_PROGRAM("qpdf");
    const std::string said = saidBy("qpdf --check " + file_);
    EXPECT_NE(said.find("No syntax or stream encoding errors"), std::string::npos) << said;
    EXPECT_EQ(said.find("WARNING"), std::string::npos) << said;
}

TEST_P(PdfViewers, MutoolListsTheLayers) {
    TOILE_NEEDS_PROGRAM("mutool");
    const std::string said = saidBy("mutool show " + file_ + " trailer/Root/OCProperties");
    EXPECT_NE(said.find("/OCGs"), std::string::npos) << said;
    EXPECT_NE(said.find("/Order"), std::string::npos) << said;
    EXPECT_NE(saidBy("mutool show " + file_ + " grep").find("/OCG"), std::string::npos);
}

TEST_P(PdfViewers, PdfinfoSaysTheTitleAndTheSize) {
    TOILE_NEEDS_PROGRAM("pdfinfo");
    const std::string said = saidBy("pdfinfo -enc UTF-8 " + file_);
    EXPECT_NE(said.find("Größe <38> & \"Probe\""), std::string::npos) << said;
    if (GetParam() == Paper::A4) {
        EXPECT_NE(said.find("595.276 x 841.89 pts (A4)"), std::string::npos) << said;
    }
}

TEST_P(PdfViewers, PdftotextFindsTheNames) {
    TOILE_NEEDS_PROGRAM("pdftotext");
    const std::string said = saidBy("pdftotext -enc UTF-8 " + file_ + " -");
    for (const char* name : {"前身頃", "Ärmel", "neckband"}) {
        EXPECT_NE(said.find(name), std::string::npos) << name;
    }
}

/// Longest run of dark pixels in any row of a picture as "P5" has it.
int longestDarkRun(const std::string& picture) {
    std::istringstream in(picture);
    std::string kind;
    int width = 0, height = 0, most = 0;
    in >> kind >> width >> height >> most;
    in.get();
    int longest = 0;
    for (int y = 0; y < height; ++y) {
        int run = 0;
        for (int x = 0; x < width; ++x) {
            run = in.get() < most / 2 ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    }
    return longest;
}

TEST_P(PdfViewers, TheSquareOfThePageIsAsLargeOnPaper) {
    TOILE_NEEDS_PROGRAM("pdftoppm");
    if (GetParam() != Paper::A4) {
        return;  // where it stands is known there: the first page above the map, left
    }
    const std::string picture = (folder_ / "page").string();
    // 10 pixels per mm: the square alone, a millimetre about it.
    saidBy("pdftoppm -r 254 -gray -f 1 -l 1 -x 150 -y 350 -W 600 -H 700 -singlefile " + file_ +
           " '" + picture + "'");
    const int side = longestDarkRun(folder_.read("page.pgm"));
    EXPECT_NEAR(side, 502, 1.01);  // with the width of its line, 0.2 mm
}

INSTANTIATE_TEST_SUITE_P(Papers, PdfViewers,
                         testing::Values(Paper::A4, Paper::A0, Paper::Roll914, Paper::Projector));

}  // namespace
}  // namespace toile
