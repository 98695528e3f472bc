// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "tests/bench/report/bars.h"
#include "tests/bench/report/figures.h"
#include "tests/bench/report/growth_plot.h"
#include "tests/bench/report/performance_page.h"

namespace toile::bench {
namespace {

/// A run in which the floor costs n^1.1, `curvature` twice that, and `isometric` n^1.5.
Measurements powers() {
    Measurements run;
    for (const std::string surface : kSurfaces) {
        for (const std::string size : kSizes) {
            const double n = std::stod(size), floor = 1e-6 * std::pow(n, 1.1);
            const std::string piece = surface + "/" + size;
            const auto add = [&](const std::string& name, double seconds) {
                run.add(name + "/min_time:0.050/repeats:2/process_time", seconds, 9,
                        {{"triangles", n}});
                run.add(name + "/min_time:0.050/repeats:2/process_time", 2 * seconds, 9,
                        {{"triangles", n}});
            };
            add("floor/" + piece + "/one", floor);
            add("floor/" + piece + "/other", 1.5 * floor);
            add("curvature/" + piece, 2 * floor);
            add("isometric/" + piece, 1e-6 * std::pow(n, 1.5));
        }
    }
    return run;
}

TEST(BenchReport, NamesLoseWhatGoogleBenchmarkAdds) {
    EXPECT_EQ(plainName("curvature/panel/45000/min_time:0.050/repeats:5/process_time/real_time"),
              "curvature/panel/45000");
    EXPECT_EQ(plainName("plainScan"), "plainScan");
    EXPECT_EQ(plainName("memory/head/1000000/isometric/iterations:1"),
              "memory/head/1000000/isometric");
}

TEST(BenchReport, ARunIsReadWithItsUnitsCountersAndMachine) {
    const Measurements run = readRun(R"({
        "context": {"date": "2026-01-02", "num_cpus": 2, "CHOLMOD": "3.0.14"},
        "benchmarks": [
            {"name": "a/b/process_time", "run_type": "iteration", "iterations": 3, "threads": 1,
             "real_time": 7.0, "cpu_time": 5.0, "time_unit": "ms", "triangles": 10},
            {"name": "a/b/process_time", "run_type": "iteration", "iterations": 3, "threads": 1,
             "real_time": 7.0, "cpu_time": 4000.0, "time_unit": "us", "triangles": 10},
            {"name": "a/b_cv", "run_type": "aggregate", "real_time": 1, "cpu_time": 1,
             "time_unit": "ms", "flips": NaN, "steps": -Infinity},
            {"name": "c/real_time", "run_type": "iteration", "real_time": 2.0, "cpu_time": 1.0,
             "time_unit": "s"},
            {"name": "gone", "run_type": "iteration", "error_occurred": true,
             "error_message": "its file is not there"}]})");
    EXPECT_EQ(run.machine.at("CHOLMOD"), "3.0.14");
    EXPECT_EQ(run.all().size(), 2u);
    EXPECT_DOUBLE_EQ(*run.lowest("a/b"), 4e-3);
    EXPECT_DOUBLE_EQ(run.find("a/b")->median(), 4.5e-3);
    EXPECT_DOUBLE_EQ(*run.lowest("c"), 2);  // wall-clock time
    EXPECT_DOUBLE_EQ(*run.ratio("c", "a/b"), 500);
    EXPECT_DOUBLE_EQ(run.find("a/b")->lowestWall(), 7e-6);
    EXPECT_DOUBLE_EQ(*run.wallRatio("c", "a/b"), 2 / 7e-6);
    EXPECT_DOUBLE_EQ(*run.counter("a/b", "triangles"), 10);
    EXPECT_EQ(run.find("a/b")->counters.size(), 1u);
    EXPECT_FALSE(run.ratio("c", "gone"));
    EXPECT_THROW(readRun("{}"), std::runtime_error);
    EXPECT_THROW(readRun("no JSON"), std::runtime_error);
}

TEST(BenchReport, TheFloorIsTheFastestCandidateOfThatPieceAlone) {
    Measurements run;
    run.add("floor/panel/45000/slow", 3, 3, {});
    run.add("floor/panel/45000/fast", 2, 2, {});
    run.add("floor/panel/450000/other", 1, 1, {});
    ASSERT_TRUE(run.floorOf("panel/45000"));
    EXPECT_EQ(run.floorOf("panel/45000")->candidate, "fast");
    EXPECT_FALSE(run.floorOf("head/45000"));
}

TEST(BenchReport, ExponentsAreThoseOfThePowers) {
    const Measurements run = powers();
    EXPECT_NEAR(*growthExponent(run, "floor", "panel"), 1.1, 1e-9);
    EXPECT_NEAR(*growthExponent(run, "isometric", "head"), 1.5, 1e-9);
    EXPECT_FALSE(growthExponent(run, "wang2005", "head"));
}

TEST(BenchReport, BarsAreThoseWithFigures) {
    const auto bars = barsOf(powers());
    int floors = 0, growths = 0;
    for (const Bar& bar : bars) {
        if (bar.what.ends_with("/ floor")) {
            ++floors;
            EXPECT_NEAR(bar.measured, 2, 1e-9) << bar.what;
            EXPECT_FALSE(bar.kept()) << bar.what;
        } else if (bar.what.starts_with("growth of")) {
            ++growths;
            EXPECT_EQ(bar.kept(), bar.what.find("curvature") != bar.what.npos) << bar.what;
        }
    }
    EXPECT_EQ(floors, 8);
    EXPECT_EQ(growths, 4);
}

TEST(BenchReport, APairOfResolveAndColdBecomesABar) {
    Measurements run;
    run.add("resolveDart/panel/45000/isometric", 0.3, 1, {});
    run.add("coldDart/panel/45000/isometric", 1, 1, {});
    const auto bars = barsOf(run);
    ASSERT_EQ(bars.size(), 1u);
    EXPECT_NEAR(bars.front().measured, 0.3, 1e-12);
    EXPECT_TRUE(bars.front().kept());
    EXPECT_EQ(line(bars.front()),
              "resolveDart/panel/45000/isometric / coldDart/panel/45000/isometric: 0.300, at most "
              "0.500: kept");
}

TEST(BenchReport, AStageIsLinearInTheOutlineWhereItsTimePerVertexStays) {
    Measurements run;
    for (const std::string size : kOutlineSizes) {
        const double n = std::stod(size);
        run.add("outline/newton/" + size, 1e-6 * n, 1, {});
        run.add("outline/isometric/" + size, 1e-9 * n * n, 1, {});
    }
    EXPECT_NEAR(*timePerVertexGrowth(run, "newton"), 1, 1e-9);
    EXPECT_NEAR(*timePerVertexGrowth(run, "isometric"), 10, 1e-9);
    EXPECT_FALSE(timePerVertexGrowth(run, "svg"));
    for (const Bar& bar : barsOf(run)) {
        EXPECT_EQ(bar.kept(), bar.what.find("newton") != bar.what.npos) << bar.what;
    }
    const std::string page = performancePage(run);
    EXPECT_NE(page.find("| isometric | 2000 | 20000 | 200000 | 10.0 |"), std::string::npos) << page;
    EXPECT_EQ(page.find("| svg |"), std::string::npos);
}

TEST(BenchReport, FiguresHaveThreeDigits) {
    EXPECT_EQ(significant(1.2345), "1.23");
    EXPECT_EQ(significant(0.012345), "0.0123");
    EXPECT_EQ(significant(12345), "12345");
    EXPECT_EQ(significant(1.00031), "1.00031");
    EXPECT_EQ(significant(1), "1.00");
    EXPECT_EQ(significant(0), "0");
    EXPECT_EQ(milliseconds(0.0442), "44.2");
    EXPECT_EQ(percent(0.123), "12 %");
    EXPECT_EQ(percent(0.0123), "1.2 %");
}

TEST(BenchReport, ThePlotIsWellFormedWithALineAndANamePerSeries) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(growthPlot(powers()).c_str()));
    EXPECT_EQ(document.select_nodes("//polyline").size(), 6u);  // three on each surface
    EXPECT_EQ(document.select_nodes("//text[@class='name']").size(), 6u);
    // One over the other in their field, with room for each.
    double last = -100;
    int inFirst = 0;
    for (const auto& node : document.select_nodes("//text[@class='name']")) {
        const double y = node.node().attribute("y").as_double();
        if (inFirst++ < 3) {
            EXPECT_GE(y, last + 13);
            last = y;
        }
    }
    EXPECT_TRUE(document.load_string(growthPlot(Measurements()).c_str()));
}

TEST(BenchReport, ThePageShowsWhatWasMeasuredAndLeavesOutWhatWasNot) {
    const std::string page = performancePage(powers());
    EXPECT_NE(page.find("| curvature/panel/45000 / floor | at most 1.35 | 2.00 | **not kept** |"),
              std::string::npos);
    EXPECT_NE(page.find("images/performance-growth.svg"), std::string::npos);
    EXPECT_EQ(page.find("## Memory"), std::string::npos);
    EXPECT_EQ(page.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace toile::bench
