// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/formats/read_backs.h"
#include "tests/core/formats/export_fixtures.h"
#include "tests/core/formats/exported_garments.h"
#include "tests/core/support/generator.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

constexpr DxfProfile kAllProfiles[] = {DxfProfile::Astm, DxfProfile::Aama, DxfProfile::Plain};
constexpr LengthUnit kAllUnits[] = {LengthUnit::Millimetre, LengthUnit::Centimetre,
                                    LengthUnit::Inch};

Result<ReadBack> readAgain(const test::ExportedGarment& made, const ExportOptions& options,
                           std::string bytes) {
    return readDxfBack({{"", std::move(bytes)}}, made.source(options));
}

void expectReadBack(const test::ExportedGarment& made) {
    for (const DxfProfile profile : kAllProfiles) {
        for (const LengthUnit unit : kAllUnits) {
            ExportOptions options = test::dxfOptions(profile, unit);
            options.dxf.controlPiece = options.dxf.ruleTable = unit == LengthUnit::Inch;
            const auto files = formatOf(FormatId::Dxf).write(made.source(options));
            ASSERT_TRUE(files);
            const auto found = readDxfBack(*files, made.source(options));
            ASSERT_TRUE(found) << sentence(found.error());
            EXPECT_EQ(static_cast<std::size_t>(found->pieces), made.laid.marker.copies.size());
            EXPECT_LE(found->largest, profile == DxfProfile::Plain ? 1e-3 : kReadBackLengths);
        }
    }
}

TEST(DxfReadBack, FindsWhatWasWritten) {
    expectReadBack(test::exported(test::sewingPattern()));
    for (const NotchForm form : {NotchForm::Slit, NotchForm::V, NotchForm::T, NotchForm::Castle}) {
        expectReadBack(test::markedPieces(form));
    }
}

class DxfReadBackOfGarments : public testing::TestWithParam<const char*> {};

TEST_P(DxfReadBackOfGarments, FindsWhatWasWritten) {
    TOILE_NEEDS_SHARED(test::dataFile(GetParam()));
    test::ExportedGarment made = test::exported(GetParam(), true);
    expectReadBack(made);
    test::cutByHalf(made);
    expectReadBack(made);
    expectReadBack(test::exported(GetParam(), false));
}

INSTANTIATE_TEST_SUITE_P(Garments, DxfReadBackOfGarments,
                         testing::Values("samples/tshirt.obj", "samples/bodice.obj",
                                         "samples/trousers.obj", "garments/skirt_clo.obj"),
                         [](const auto& tested) {
                             std::string name = tested.param;
                             std::ranges::replace_if(
                                 name, [](char c) { return c == '/' || c == '.'; }, '_');
                             return name;
                         });

/// Where the values of coordinates stand that a machine cuts by.
std::vector<std::size_t> coordinatesOf(const std::string& bytes) {
    std::vector<std::size_t> places;
    std::string entity, code;
    bool isValue = false;
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = bytes.find("\r\n", at);
        const std::string line = bytes.substr(at, end - at);
        if (!isValue) {
            code = line;
        } else if (code == "  0") {
            entity = line;
        } else if ((code == " 10" || code == " 20") &&
                   (entity == "VERTEX" || entity == "POINT" || entity == "INSERT")) {
            places.push_back(at);
        }
        isValue = !isValue;
        at = end + 2;
    }
    return places;
}

TEST(DxfReadBack, FindsAnyDigitThatIsAnother) {
    test::ExportedGarment made = test::markedPieces();
    for (const DxfProfile profile : kAllProfiles) {
        const ExportOptions options = test::dxfOptions(profile);
        const std::string bytes = test::dxfOf(made, options);
        const std::vector<std::size_t> places = coordinatesOf(bytes);
        ASSERT_GT(places.size(), 500U);
        // A prime step meets all kinds of entities.
        for (std::size_t k = 0; k < places.size(); k += profile == DxfProfile::Aama ? 3 : 13) {
            std::string changed = bytes;
            char& digit = changed[changed.find('.', places[k]) + 1];
            // By half a millimetre.
            digit = digit >= '5' ? static_cast<char>(digit - 5) : static_cast<char>(digit + 5);
            const auto found = readAgain(made, options, changed);
            ASSERT_FALSE(found) << bytes.substr(places[k] - 40, 60);
            EXPECT_EQ(found.error().code, ErrorCode::NotReadBack);
        }
    }
}

TEST(DxfReadBack, FindsAGrainLineThatRunsElsewhere) {
    const test::ExportedGarment made = test::exported("samples/tshirt.obj", true);
    const ExportOptions options = test::dxfOptions(DxfProfile::Aama);
    std::string bytes = test::dxfOf(made, options);
    EXPECT_TRUE(readAgain(made, options, bytes));
    const std::string begin = "LINE\r\n  8\r\n7\r\n 10\r\n";
    const std::size_t at = bytes.find(begin);
    ASSERT_NE(at, std::string::npos);
    bytes.insert(at + begin.size(), "1");
    EXPECT_FALSE(readAgain(made, options, bytes));
}

TEST(DxfReadBack, FindsBlocksThatAreInsertedLargerOrTurned) {
    const test::ExportedGarment made = test::markedPieces();
    for (const DxfProfile profile : {DxfProfile::Astm, DxfProfile::Aama}) {
        const ExportOptions options = test::dxfOptions(profile);
        const std::string bytes = test::dxfOf(made, options);
        const std::string begin = "INSERT\r\n  8\r\n1\r\n";
        const std::size_t at = bytes.find(begin);
        ASSERT_NE(at, std::string::npos);
        for (const char* change : {" 41\r\n2\r\n", " 42\r\n-1\r\n", " 50\r\n90\r\n"}) {
            std::string changed = bytes;
            changed.insert(at + begin.size(), change);
            EXPECT_FALSE(readAgain(made, options, changed)) << change;
        }
    }
}

TEST(DxfReadBack, FindsWhatIsMissing) {
    const test::ExportedGarment made = test::markedPieces();
    for (const DxfProfile profile : kAllProfiles) {
        const ExportOptions options = test::dxfOptions(profile);
        const std::string bytes = test::dxfOf(made, options);
        for (const std::string entity : {"VERTEX", "POINT", "POLYLINE", "INSERT", "BLOCK", "EOF"}) {
            const std::string begin = "  0\r\n" + entity + "\r\n";
            const std::size_t at = bytes.find(begin);
            if (at == std::string::npos) {
                continue;
            }
            std::size_t end = bytes.find("\r\n  0\r\n", at + begin.size());
            end = end == std::string::npos ? bytes.size() : end + 2;
            std::string without = bytes;
            without.erase(at, end - at);
            EXPECT_FALSE(readAgain(made, options, without)) << entity;
        }
        for (const char* text :
             {"Units: METRIC", "Quantity", "Piece Name", "POLYLINE\r\n  8\r\n7"}) {
            std::string without = bytes;
            if (const std::size_t at = without.find(text); at != std::string::npos) {
                without[at] = 'x';
                EXPECT_FALSE(readAgain(made, options, without)) << text;
            }
        }
        EXPECT_FALSE(readDxfBack({}, made.source(options)));
    }
}

TEST(DxfReadBack, RefusesAnotherUnit) {
    const test::ExportedGarment made = test::exported(test::sewingPattern());
    for (const DxfProfile profile : kAllProfiles) {
        const std::string bytes = test::dxfOf(made, test::dxfOptions(profile));
        for (const LengthUnit unit : {LengthUnit::Centimetre, LengthUnit::Inch}) {
            EXPECT_FALSE(readAgain(made, test::dxfOptions(profile, unit), bytes));
        }
    }
    ExportOptions options = test::dxfOptions(DxfProfile::Astm);
    options.dxf.ruleTable = true;
    auto files = formatOf(FormatId::Dxf).write(made.source(options));
    ASSERT_TRUE(files);
    EXPECT_TRUE(readDxfBack(*files, made.source(options)));
    files->back().bytes.resize(40);
    EXPECT_FALSE(readDxfBack(*files, made.source(options)));
}

TEST(DxfReadBack, SurvivesAnyBytes) {
    const test::ExportedGarment made = test::markedPieces();
    test::Generator random(7);
    for (const DxfProfile profile : kAllProfiles) {
        const ExportOptions options = test::dxfOptions(profile);
        const std::string bytes = test::dxfOf(made, options);
        for (int run = 0; run < 150; ++run) {
            std::string changed = bytes;
            for (int k = random.whole(1, 8); k > 0; --k) {
                const auto at =
                    static_cast<std::size_t>(random.whole(0, static_cast<int>(changed.size()) - 1));
                switch (random.whole(0, 3)) {
                    case 0:
                        changed[at] = static_cast<char>(random.whole(0, 255));
                        break;
                    case 1:
                        changed.erase(at, static_cast<std::size_t>(random.whole(1, 200)));
                        break;
                    case 2:
                        changed.insert(at, bytes.substr(at / 2, 300));
                        break;
                    default:
                        changed.insert(at, random.chance(0.5) ? "nan" : "9e307");
                }
                if (changed.empty()) {
                    changed = "0";
                }
            }
            const auto found = readAgain(made, options, changed);
            EXPECT_TRUE(found || found.error().code == ErrorCode::NotReadBack);
        }
    }
}

}  // namespace
}  // namespace toile
