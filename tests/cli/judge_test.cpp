// SPDX-License-Identifier: GPL-3.0-or-later
// Our report against an independent judge of OBJ files with UV, where that stands beside the
// project and Python with numpy is there to run it.
#include <cmath>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

struct Judged {
    const char* name;
    const char* file;
    const char* unit;
    const char* millimetres;
    /// Dart tips turn by about 2 pi. There the judge's planar angle is 0 or 2 pi as rounding has
    /// it; our Pi_theta takes differences modulo 2 pi and cannot be compared.
    bool hasDarts = false;
};

class Judge : public testing::TestWithParam<std::tuple<Judged, const char*>> {};

/// A Python that has numpy: the one on the path may be another than the system's.
std::string pythonWithNumpy() {
    for (const char* python : {"python3", "/usr/bin/python3"}) {
        if (test::run(python, {"-c", "import numpy"}).status == 0) {
            return python;
        }
    }
    return "";
}

void expectSame(const nlohmann::json& ours, const nlohmann::json& theirs, double tolerance = 1e-6) {
    const double a = ours.get<double>();
    const double b = theirs.get<double>();
    EXPECT_LE(std::abs(a - b), tolerance * std::max(std::abs(a), std::abs(b)) + 1e-12)
        << a << " and " << b;
}

TEST_P(Judge, AgreesWithTheReport) {
    const auto& [garment, method] = GetParam();
    const auto judge = test::sharedFile("../tools/evaluate.py");
    const auto input = test::sharedFile(garment.file);
    TOILE_NEEDS_SHARED(judge);
    TOILE_NEEDS_SHARED(input);
    const std::string python = pythonWithNumpy();
    if (python.empty()) {
        GTEST_SKIP() << "needs python3 with numpy";
    }
    const test::TemporaryFolder folder;
    const std::string obj = (folder / "flat.obj").string();
    const auto flatten = test::run(
        TOILE_PROGRAM, {"flatten", input.string(), "--unit", garment.unit, "--method", method, "-o",
                        obj, "--report", (folder / "report.json").string()});
    // Strain that no cloth takes and outlines that cross are faults, and the files are written all
    // the same.
    const bool hasFault = flatten.err.find("toile: fault:") != std::string::npos ||
                          flatten.err.find("crosses itself") != std::string::npos;
    ASSERT_EQ(flatten.status, hasFault ? 1 : 0) << flatten.err;
    const auto judged = test::run(
        python, {judge.string(), obj, "--pieces", "--v-scale", garment.millimetres, "--json"});
    ASSERT_EQ(judged.status, 0) << judged.err;
    // The judge writes Infinity for the energy of a flipped triangle, which no JSON parser takes.
    const std::string finite = std::regex_replace(judged.out, std::regex("-?Infinity|NaN"), "null");
    const auto verdict = nlohmann::json::parse(finite);
    const auto report = nlohmann::json::parse(folder.read("report.json"));
    ASSERT_EQ(verdict.size(), report["pieces"].size());
    for (std::size_t k = 0; k < verdict.size(); ++k) {
        const auto& ours = report["pieces"][k];
        const auto& theirs = verdict[k];
        SCOPED_TRACE(ours["name"].get<std::string>());
        ASSERT_FALSE(theirs.contains("bad")) << theirs["bad"];
        EXPECT_FALSE(theirs["mirrored"].get<bool>());
        if (!garment.hasDarts) {
            expectSame(ours["pi_theta"], theirs["Pi_theta"]);
        }
        expectSame(ours["pi_e"], theirs["Pi_E"]);
        expectSame(ours["pi_a"], theirs["Pi_A"]);
        expectSame(ours["quasi_conformal_mean"], theirs["qc_mean"]);
        EXPECT_EQ(ours["flipped_triangles"], theirs["flipped"]);
        EXPECT_EQ(ours["outline_crossings"], theirs["crossings"]);
        if (ours["symmetric_dirichlet"].is_null()) {
            EXPECT_GT(theirs["flipped"].get<int>(), 0);
        } else {
            expectSame(4 * ours["symmetric_dirichlet"].get<double>(), theirs["SD"]);
        }
        if (std::string(method) != "natural") {  // both at rounding level, differently rounded
            EXPECT_LE(ours["max_boundary_length_error"].get<double>(), 1e-9);
            EXPECT_LE(theirs["bl_raw_max"].get<double>(), 1e-9);
        } else {
            expectSame(ours["max_boundary_length_error"], theirs["bl_raw_max"]);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    SharedSlow, Judge,
    testing::Combine(testing::Values(Judged{"tee", "garments/tee_sim_pieces.obj", "cm", "10"},
                                     Judged{"polo", "garments/polo_pieces.obj", "cm", "10"},
                                     Judged{"dress14", "garments/dress14_pieces.obj", "m", "1000"},
                                     Judged{"skirt", "garments/skirt_clo.obj", "mm", "1", true},
                                     Judged{"face", "disks/face.obj", "m", "1000"},
                                     Judged{"hemisphere", "disks/hemisphere.obj", "m", "1000"},
                                     Judged{"nefertiti", "disks/nefertiti.off", "m", "1000"},
                                     Judged{"maxface", "disks/maxface.obj", "m", "1000"},
                                     Judged{"tiny", "nasty/panel_tiny.obj", "cm", "10"},
                                     Judged{"far", "nasty/panel_far.obj", "cm", "10"}),
                     testing::Values("isometric", "curvature", "wang2005", "natural")),
    [](const auto& shown) {
        return std::string(std::get<0>(shown.param).name) + "_" + std::get<1>(shown.param);
    });

}  // namespace
}  // namespace toile
