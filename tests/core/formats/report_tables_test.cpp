// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/tables/report_tables.h"

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "core/formats/export_file.h"
#include "core/formats/writers.h"
#include "core/toile/pipeline.h"
#include "tests/core/support/laid_rows.h"
#include "tests/core/support/shared_data.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

struct Shirt {
    Garment garment;
    LineSettings lines = withPattern({});
    PieceResults results;
    LaidOutPattern laid;

    Shirt() {
        Progress progress;
        garment = *loadGarment({test::dataFile("samples/tshirt.obj")}, {}, progress);
        results = flattenGarment(garment, {}, progress, 0, lines);
        laid = inRows(garment, results, lines);
    }
    ExportSource source() const { return {garment, results, laid, {}, {}, lines}; }
};

TEST(ReportTables, EveryRowIsAsLongAsItsHead) {
    const Shirt shirt;
    const WalkedGarment walked =
        walkGarment(shirt.garment, shirt.results, shirt.laid.pattern, shirt.lines.notches);
    for (const ReportTable& table :
         {pieceTable(shirt.laid.pattern, shirt.results), ledgerTable(shirt.garment, shirt.results),
          edgeTable(shirt.laid.pattern), walkTable(shirt.garment, walked.notches, walked.walks)}) {
        EXPECT_FALSE(table.rows.empty()) << table.title;
        for (const auto& row : table.rows) {
            EXPECT_EQ(row.size(), table.head.size()) << table.title;
        }
    }
    EXPECT_EQ(ledgerTable(shirt.garment, shirt.results).rows.size(), walked.walks.size());
}

TEST(ReportTables, CsvKeepsCellsApartAndFormulasText) {
    const ReportTable table{
        "", "", {"a,b", "c"}, {{"say \"hi\"", "=1+1"}, {"-2.5", "-"}, {"x\ny", ""}}};
    EXPECT_EQ(writeCsv(table), "\"a,b\",c\r\n\"say \"\"hi\"\"\",\"\t=1+1\"\r\n-2.5,-\r\nx y,\r\n");
}

TEST(HtmlReport, IsWellFormedAndHoldsDrawingAndTables) {
    const Shirt shirt;
    const std::string page = writeHtmlReport(shirt.source());
    EXPECT_EQ(page, writeHtmlReport(shirt.source()));
    // XHTML but for the void elements, which are closed here to let an XML reader judge the rest.
    std::string xml = page.substr(page.find("<body>"));
    xml.resize(xml.find("</html>"));
    pugi::xml_document document;
    const auto parsed = document.load_string(xml.c_str());
    ASSERT_TRUE(parsed) << parsed.description() << xml.substr(parsed.offset, 100);
    const pugi::xml_node body = document.child("body");
    EXPECT_TRUE(body.child("figure").child("svg"));
    EXPECT_EQ(std::distance(body.children("h2").begin(), body.children("h2").end()), 4);
    EXPECT_NE(page.find("<h2>Free edges</h2>"), std::string::npos);
    EXPECT_EQ(page.find("http://www.w3.org/TR"), std::string::npos);
    EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST(HtmlReport, HoldsThePicturesThatOthersProvide) {
    const Shirt shirt;
    provideReportPictures([](const ExportSource& source) -> std::vector<ReportPicture> {
        return {{"a < b", source.garment().pieces.empty() ? "" : "QUJD"}};
    });
    const std::string page = writeHtmlReport(shirt.source());
    provideReportPictures(nullptr);
    EXPECT_NE(page.find("<img alt=\"a &lt; b\" src=\"data:image/png;base64,QUJD\">"),
              std::string::npos);
    EXPECT_EQ(writeHtmlReport(shirt.source()).find("<img"), std::string::npos);
}

TEST(HtmlReport, NamesAreNoMarkup) {
    Shirt shirt;
    shirt.laid.pattern.name = "<b>&\"";
    shirt.laid.pattern.pieces[0].name = "</td><script>";
    const std::string page = writeHtmlReport(shirt.source());
    EXPECT_NE(page.find("<h1>&lt;b&gt;&amp;&quot;</h1>"), std::string::npos);
    EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST(CsvExport, WritesOneFilePerTable) {
    const Shirt shirt;
    const test::TemporaryFolder folder;
    const auto written = exportFile(folder / "shirt.csv", shirt.source());
    ASSERT_TRUE(written);
    ASSERT_EQ(written->files.size(), 4U);
    EXPECT_EQ(written->files[1].filename(), "shirt-seams.csv");
    EXPECT_EQ(written->files[2].filename(), "shirt-walk.csv");
    EXPECT_EQ(written->files[3].filename(), "shirt-edges.csv");
    for (const auto& file : written->files) {
        EXPECT_TRUE(std::filesystem::exists(file)) << file;
    }
}

}  // namespace
}  // namespace toile
