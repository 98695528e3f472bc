// SPDX-License-Identifier: GPL-3.0-or-later
// The seams of real garments under two methods: the tables of docs/seams.md.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/docs_table.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Json = nlohmann::json;

/// Seams of the report, free edges aside, by name.
Json seamsOf(const std::filesystem::path& garment, const std::string& method,
             const std::string& split = "uv") {
    const test::TemporaryFolder folder;
    const auto run =
        test::run(TOILE_PROGRAM, {"flatten", garment.string(), "--split", split, "--method", method,
                                  "--report", (folder / "a.json").string()});
    EXPECT_LE(run.status, 1) << run.err;  // other methods strain pieces beyond any cloth
    Json seams = Json::object();
    const Json report = Json::parse(folder.read("a.json"));
    for (const Json& seam : report["seams"]) {
        if (seam["kind"] != "free") {
            seams[seam["name"].get<std::string>()] = seam;
        }
    }
    return seams;
}

std::string millimetres(double value, const char* format = "%.2f") {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return std::string(text) == "-0.00" ? "0.00" : text;
}

double errorOf(const Json& seam) {
    return std::abs(seam["error_mm"].get<double>());
}

/// A row per seam, the worst under the conformal map first.
std::string tableOf(const Json& exact, const Json& natural) {
    std::vector<std::string> names;
    for (const auto& [name, seam] : natural.items()) {
        names.push_back(name);
    }
    std::sort(names.begin(), names.end(), [&natural](const auto& a, const auto& b) {
        return errorOf(natural[a]) > errorOf(natural[b]);
    });
    std::string table =
        "| Seam | 3D mm | `wang2005` left, right | Δ mm | `natural` left, right | Δ mm |\n"
        "|---|--:|--:|--:|--:|--:|\n";
    const auto sides = [](const Json& seam) {
        return millimetres(seam["length_2d_left"]) + ", " + millimetres(seam["length_2d_right"]);
    };
    for (const std::string& name : names) {
        table += "| " + name + " | " + millimetres(natural[name]["length_3d"]) + " | " +
                 sides(exact[name]) + " | " + millimetres(exact[name]["delta_mm"]) + " | " +
                 sides(natural[name]) + " | " + millimetres(natural[name]["delta_mm"], "%+.2f") +
                 " |\n";
    }
    return table;
}

class Ledger : public testing::TestWithParam<const char*> {};

TEST_P(Ledger, IsEvenByAMethodThatKeepsLengths) {
    const std::string name = GetParam();
    const auto garment = test::sharedFile("garments/" + name + ".obj");
    TOILE_NEEDS_SHARED(garment);
    const Json exact = seamsOf(garment, "wang2005");
    const Json natural = seamsOf(garment, "natural");
    ASSERT_EQ(exact.size(), natural.size());
    ASSERT_GE(exact.size(), 10U);
    for (const auto& [seam, values] : exact.items()) {
        EXPECT_LE(errorOf(values), 1e-6) << seam;
    }
    if (name == "tee_sim" || name == "tshirt") {
        test::updateTableInDocs("seams.md", name, tableOf(exact, natural));
    }
}

class SampleLedger : public testing::TestWithParam<std::pair<const char*, std::size_t>> {};

TEST_P(SampleLedger, IsEvenByAMethodThatKeepsLengthsAndNotByOneThatDoesNot) {
    const auto& [name, seams] = GetParam();
    const auto garment = test::dataFile(std::string("samples/") + name + ".obj");
    const Json exact = seamsOf(garment, "wang2005", "auto");
    const Json natural = seamsOf(garment, "natural", "auto");
    EXPECT_EQ(exact.size(), seams);
    EXPECT_EQ(natural.size(), seams);
    double worst = 0;
    for (const auto& [seam, values] : exact.items()) {
        EXPECT_LE(errorOf(values), 1e-6) << seam;
        worst = std::max(worst, errorOf(natural.at(seam)));
    }
    EXPECT_GT(worst, 0.1);  // mm
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleLedger,
                         testing::Values(std::pair("tshirt", 14), std::pair("bodice", 11),
                                         std::pair("trousers", 11), std::pair("cap", 10),
                                         std::pair("skirt", 14)),
                         [](const auto& shown) { return std::string(shown.param.first); });
INSTANTIATE_TEST_SUITE_P(Shared, Ledger,
                         testing::Values("dress", "longsleeve", "polo", "tee_sim", "tshirt"));

}  // namespace
}  // namespace toile
