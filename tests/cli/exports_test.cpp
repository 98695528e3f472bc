// SPDX-License-Identifier: GPL-3.0-or-later
// What is written, and the tables of docs/exports.md.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/base/text.h"
#include "core/formats/export_file.h"
#include "core/formats/formats.h"
#include "core/toile/pipeline.h"
#include "tests/cli/docs_table.h"
#include "tests/cli/run_program.h"
#include "tests/core/readers/any_read_back.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

const std::string kExportedShirt = std::string(TOILE_SOURCE_DIR) + "/resources/samples/tshirt.obj";

std::string joined(std::span<const char* const> words, const char* between) {
    std::string text;
    for (const char* word : words) {
        text += (text.empty() ? "" : between) + std::string(word);
    }
    return text;
}

TEST(ExportsPage, TheFormatsAreThoseOfTheProgram) {
    std::string table =
        "| Format | Endings | For | Layers | True scale | Curves | Pages | Read back |\n"
        "|---|---|---|:-:|:-:|:-:|:-:|:-:|\n";
    const auto mark = [](bool has) { return has ? " x |" : "  |"; };
    for (const Format& format : formats()) {
        table += std::string("| ") + format.name + " | `" + joined(format.endings, "`, `") +
                 "` | " + format.use + " |" + mark(format.layers) + mark(format.trueScale) +
                 mark(format.curves) + mark(format.pages) + mark(format.readBack) + "\n";
    }
    test::expectTableInDocs("exports.md", "formats", table);
}

TEST(ExportsPage, TheChoicesAreThoseOfTheProgram) {
    std::string table = "| Option | Of | |\n|---|---|---|\n";
    for (const FormatOption& option : formatOptions()) {
        std::string of, values = joined(option.words, "\\|");
        for (const FormatId id : option.formats) {
            const std::string ending = formatOf(id).endings.front();
            of += (of.empty() ? "`" : ", `") + ending + "`";
        }
        values = option.isSwitch ? "" : values.empty() ? " NUMBER" : " " + values;
        table += std::string("| `--") + option.name + values + "` | " + of + " | " + option.help +
                 " |\n";
    }
    test::expectTableInDocs("exports.md", "choices", table);
}

TEST(ExportsPage, WhatIsReadBackIsWhatIsMeasured) {
    Progress progress;
    const auto garment = loadGarment({kExportedShirt}, {}, progress);
    ASSERT_TRUE(garment);
    const LineSettings lines = withPattern({});
    const PieceResults results = flattenGarment(*garment, {}, progress, 0, lines);
    const LaidOutPattern laid = inRows(*garment, results, lines);
    std::string table = "| Format | Pieces | Sides of seams | Within mm |\n|---|--:|--:|--:|\n";
    const auto add = [&](const Format& format, const std::string& name,
                         const ExportOptions& options) {
        const ExportSource source(*garment, results, laid, options, {}, lines);
        const auto files = format.write(source);
        ASSERT_TRUE(files) << name;
        const auto found = test::readBack(format, *files, source);
        ASSERT_TRUE(found) << name << ": " << found.error().detail;
        // Rounded up, so that the last digits of another machine do not show.
        const double within = found->largest <= 0.001   ? 0.001
                              : found->largest <= 0.01  ? 0.01
                              : found->largest <= 0.025 ? 0.025
                                                        : 0.05;
        table += "| " + name + " | " + std::to_string(found->pieces) + " | " +
                 std::to_string(found->seams) + " | " + shortest(within) + " |\n";
    };
    for (const Format& format : formats()) {
        if (!format.write || !test::isReadBack(format)) {  // PNG needs the window
            continue;
        }
        if (format.id != FormatId::Dxf) {
            add(format, format.name, {});
            continue;
        }
        for (const char* profile : {"astm", "aama", "plain"}) {
            ExportOptions options;
            for (const FormatOption& option : formatOptions()) {
                if (option.name == std::string("dxf-profile")) {
                    option.set(options, profile);
                }
            }
            add(format, std::string(format.name) + ", `" + profile + "`", options);
        }
    }
    test::expectTableInDocs("exports.md", "read-back", table);
}

/// `arguments` with an output of every format that there is without the window.
std::vector<std::string> intoEveryFormat(std::vector<std::string> arguments,
                                         const test::TemporaryFolder& folder) {
    for (const Format& format : formats()) {
        if (format.id != FormatId::Png) {
            arguments.push_back("-o");
            arguments.push_back((folder / ("a" + std::string(format.endings.front()))).string());
        }
    }
    return arguments;
}

TEST(Exports, WriteEveryFormatAtOnceAndSayWhatWasReadBack) {
    const test::TemporaryFolder folder;
    const std::vector<std::string> arguments = intoEveryFormat(
        {"flatten", kExportedShirt, "--pattern", "--dxf-rul", "--obj-pieces"}, folder);
    int read = 0;
    for (const Format& format : formats()) {
        read += format.id != FormatId::Png && format.readBack ? 1 : 0;
    }
    const auto run = test::run(TOILE_PROGRAM, arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    int said = 0;
    for (std::size_t at = run.out.find("read back: 5 pieces"); at != std::string::npos;
         at = run.out.find("read back: 5 pieces", at + 1)) {
        ++said;
    }
    EXPECT_EQ(said, read) << run.out;
    for (const char* file : {"a.rul", "a-front.obj", "a-seams.csv", "a.specification.json"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
    }
}

TEST(Exports, WithoutAFlatPieceAreWrittenAllTheSameAndItIsSaid) {
    const test::TemporaryFolder folder;
    const auto ball = folder.write("ball.obj", test::kBall);
    const auto run = test::run(TOILE_PROGRAM, intoEveryFormat({"flatten", ball.string()}, folder));
    EXPECT_EQ(run.status, 1) << run.err;
    EXPECT_NE(run.err.find("contain no pattern"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("another program"), std::string::npos) << run.err;
    for (const Format& format : formats()) {
        const std::string name = "a" + std::string(format.endings.front());
        EXPECT_EQ(std::filesystem::exists(folder / name), format.id != FormatId::Png) << name;
    }
}

TEST(Exports, PresetsChooseAndWhatIsTypedGoesBefore) {
    const test::TemporaryFolder folder;
    const auto written = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"flatten", kExportedShirt, "-o",
                                           (folder / "a.dxf").string()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(test::run(TOILE_PROGRAM, arguments).status, 0);
        return folder.read("a.dxf");
    };
    EXPECT_NE(written({}).find("Units: METRIC"), std::string::npos);
    EXPECT_NE(written({"--dxf-preset", "accumark"}).find("Units: ENGLISH"), std::string::npos);
    EXPECT_NE(written({"--dxf-preset", "accumark", "--dxf-unit", "mm"}).find("Units: METRIC"),
              std::string::npos);
    EXPECT_NE(written({"--dxf-unit", "mm", "--dxf-preset", "accumark"}).find("Units: METRIC"),
              std::string::npos);
    EXPECT_NE(written({"--dxf-preset", "laser"}).find("$INSUNITS"), std::string::npos);
    const std::vector<std::vector<std::string>> wrong{{"--dxf-preset", "paper"},
                                                      {"--overlap", "-1"},
                                                      {"--overlap", "nan"},
                                                      {"--png-dpi", "0"},
                                                      {"--paper", "a5"}};
    for (std::vector<std::string> options : wrong) {
        options.insert(options.begin(), {"flatten", kExportedShirt});
        EXPECT_EQ(test::run(TOILE_PROGRAM, options).status, 2) << options.back();
    }
}

TEST(Exports, TheLongestEndingWins) {
    EXPECT_EQ(formatOf(std::filesystem::path("a.specification.json"))->id, FormatId::GarmentCode);
    EXPECT_EQ(formatOf(std::filesystem::path("A.Specification.JSON"))->id, FormatId::GarmentCode);
    EXPECT_EQ(formatOf(std::filesystem::path("specification.json"))->id, FormatId::Report);
    EXPECT_EQ(formatOf(std::filesystem::path(".json")), nullptr);
    EXPECT_EQ(exportedPath("x/a.b.dxf", ".rul"), std::filesystem::path("x/a.b.rul"));
    EXPECT_EQ(exportedPath("a.specification.json", ".x"), std::filesystem::path("a.x"));
}

}  // namespace
}  // namespace toile
