// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of broken files: the built program takes every file of the nasty set, and the table
// in docs/input.md is what it said.
#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/docs_table.h"
#include "tests/cli/run_program.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

using Json = nlohmann::json;

struct RunResult {
    int status = 0;
    int flat = 0, failed = 0, cuts = 0;
    std::vector<std::string> said;  ///< sentences, one per code
};

std::string readText(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// One sentence for each code, with how many more there are.
std::vector<std::string> summarise(const std::vector<std::pair<std::string, std::string>>& said) {
    std::vector<std::string> codes;
    std::map<std::string, std::pair<std::string, int>> first;
    for (const auto& [code, sentence] : said) {
        auto [entry, isNew] = first.try_emplace(code, sentence, 0);
        if (isNew) {
            codes.push_back(code);
        } else {
            ++entry->second.second;
        }
    }
    std::vector<std::string> lines;
    for (const std::string& code : codes) {
        const auto& [sentence, more] = first[code];
        lines.push_back(sentence + (more > 0 ? " (" + std::to_string(more) + " more)" : ""));
    }
    return lines;
}

/// Flattens the file into every format and reads what came of it.
RunResult flatten(const std::filesystem::path& file, const std::vector<std::string>& options) {
    const test::TemporaryFolder folder;
    std::vector<std::string> arguments{"flatten", file.string()};
    for (const char* output : {"out.svg", "out.dxf", "out.obj", "out.json"}) {
        arguments.insert(arguments.end(), {"-o", (folder / output).string()});
    }
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto run = test::run(TOILE_PROGRAM, arguments);
    RunResult outcome;
    outcome.status = run.status;
    if (run.status == 3) {
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        std::string sentence = run.err.substr(0, run.err.find('\n'));
        const std::string where = file.string();
        if (const auto at = sentence.find(where); at != std::string::npos) {
            sentence.replace(at, where.size(), file.filename().string());
        }
        outcome.said = {std::regex_replace(sentence, std::regex("^toile: "), "")};
        return outcome;
    }
    for (const char* output : {"out.svg", "out.dxf", "out.obj"}) {
        const std::string text = folder.read(output);
        EXPECT_FALSE(text.empty()) << output;
        for (const char* notANumber : {" nan", "\nnan", ",nan", "-nan", " inf", "\ninf", "-inf"}) {
            EXPECT_EQ(text.find(notANumber), std::string::npos) << output;
        }
    }
    const Json report = Json::parse(folder.read("out.json"));
    std::vector<std::pair<std::string, std::string>> said;
    for (const Json& problem : report["files"][0]["problems"]) {
        said.emplace_back(problem["code"], problem["message"]);
    }
    for (const Json& problem : report["problems"]) {
        said.emplace_back(problem["code"], problem["message"]);
    }
    bool isFaulty = false;
    for (const Json& doubt : report["doubts"]) {
        if (doubt["fault"] == true) {
            said.emplace_back(doubt["code"], doubt["message"]);
            isFaulty = true;
        }
    }
    outcome.said = summarise(said);
    for (const Json& piece : report["pieces"]) {
        (piece["status"] == "flat" ? outcome.flat : outcome.failed) += 1;
        const Json& crossings = piece["outline_crossings"];
        isFaulty = isFaulty || (crossings.is_number() && crossings > 0);
    }
    outcome.cuts = static_cast<int>(report["cuts"].size());
    EXPECT_EQ(outcome.status, isFaulty || outcome.failed > 0 ? 1 : 0);
    return outcome;
}

std::string piecesCell(const RunResult& outcome) {
    if (outcome.status == 3) {
        return "refused (3)";
    }
    std::string cell = std::to_string(outcome.flat) + " flat";
    if (outcome.failed > 0) {
        cell += ", " + std::to_string(outcome.failed) + " not";
    }
    if (outcome.cuts > 0) {
        cell += "; " + std::to_string(outcome.cuts) + (outcome.cuts > 1 ? " cuts" : " cut");
    }
    return cell + " (" + std::to_string(outcome.status) + ")";
}

std::string row(const std::filesystem::path& file) {
    const RunResult plain = flatten(file, {});
    const RunResult cut = flatten(file, {"--auto-cut"});
    EXPECT_NE(plain.status, -1);
    EXPECT_TRUE(plain.status != 0 || !plain.said.empty() || plain.flat > 0);
    std::string said;
    for (const std::string& sentence : plain.said) {
        said += (said.empty() ? "" : "<br>") + sentence;
    }
    return "| `" + file.filename().string() + "` | " + piecesCell(plain) + " | " + piecesCell(cut) +
           " | " + (said.empty() ? "no messages" : said) + " |\n";
}

/// Files of the table in the manual: one for each kind of fault.
constexpr std::string_view kShown[] = {
    "bunny_holes.ply",        "elephant-with-holes.off", "empty.obj",     "hand_closed.off",
    "inverted_triangles.obj", "mask_cone.off",           "moebius.obj",   "notenoughindices.obj",
    "one_triangle.off",       "panel_badindex.obj",      "panel_nan.obj", "triple_vierbein.obj"};

TEST(NastyInputSlow, UpdatesTheTableInDocs) {
    const auto folder = test::sharedFile("nasty");
    TOILE_NEEDS_SHARED(folder);
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    ASSERT_GE(files.size(), 28U);
    std::string table =
        "| File | Pieces (exit status) | with `--auto-cut` | Messages |\n"
        "|---|---|---|---|\n";
    for (const auto& file : files) {
        SCOPED_TRACE(file.filename());
        const std::string line = row(file);
        table += std::ranges::count(kShown, file.filename().string()) > 0 ? line : "";
    }
    test::updateTableInDocs("input.md", "broken files", table);
}

/// The count that a problem of this code states first, or 0 where there is none.
int counted(const Json& problems, const std::string& code) {
    int count = 0;
    for (const Json& problem : problems) {
        std::smatch number;
        const std::string message = problem["message"];
        if (problem["code"] == code &&
            std::regex_search(message, number, std::regex("\\(([0-9]+) "))) {
            count += std::stoi(number[1]);
        }
    }
    return count;
}

/// What is said to be read, left out and repaired agrees with independent counts; false where
/// nothing could be read.
bool countsAgree(const std::filesystem::path& path, const Json& entry) {
    const std::pair<const char*, const char*> kSame[] = {
        {"index-out-of-range", "faces_out_of_range"},
        {"unused-vertices", "unused_vertices"},
        {"duplicate-faces-removed", "duplicate_faces"},
        {"vertices-split", "nonmanifold_vertices"}};
    const auto run =
        test::run(TOILE_PROGRAM, {"info", path.string(), "--json", "--split", "components"});
    if (run.status == 3) {
        EXPECT_TRUE(entry["faces"] == 0 || entry["zero_area_triangles"] == entry["faces"])
            << run.err;
        return false;
    }
    const Json file = Json::parse(run.out)["files"][0];
    EXPECT_EQ(file["vertices"], entry["vertices"]);
    EXPECT_EQ(file["faces"].get<int>() + counted(file["problems"], "index-out-of-range") +
                  counted(file["problems"], "degenerate-face-record"),
              entry["faces"].get<int>());
    for (const auto& [code, key] : kSame) {
        EXPECT_EQ(counted(file["problems"], code), entry.value(key, 0)) << code;
    }
    return true;
}

TEST(NastyInput, CountsAgreeWithTheIndex) {
    const auto indexFile = test::sharedFile("index.json");
    TOILE_NEEDS_SHARED(indexFile);
    int compared = 0;
    for (const Json& entry : Json::parse(readText(indexFile))) {
        const std::string name = entry["file"];
        if (name.starts_with("nasty/")) {
            SCOPED_TRACE(name);
            compared += countsAgree(test::sharedFile(name), entry) ? 1 : 0;
        }
    }
    EXPECT_GE(compared, 20);
}

TEST(NastyInput, CountsAgreeWithWhatWasPutIn) {
    const test::TemporaryFolder folder;
    const std::string square = "v 0 0 0\nv 90 0 0\nv 90 90 0\nv 0 90 0\nf 1 2 3\nf 1 3 4\n";
    EXPECT_TRUE(countsAgree(folder.write("sound.obj", square), {{"vertices", 4}, {"faces", 2}}));
    EXPECT_TRUE(countsAgree(folder.write("range.obj", square + "f 1 2 9\nf 7 8 9\n"),
                            {{"vertices", 4}, {"faces", 4}, {"faces_out_of_range", 2}}));
    EXPECT_TRUE(countsAgree(folder.write("doubled.obj", square + "f 2 3 1\n"),
                            {{"vertices", 4}, {"faces", 3}, {"duplicate_faces", 1}}));
    EXPECT_TRUE(countsAgree(folder.write("unused.obj", square + "v 5 5 5\nv 6 6 6\n"),
                            {{"vertices", 6}, {"faces", 2}, {"unused_vertices", 2}}));
    EXPECT_TRUE(countsAgree(folder.write("bow.obj", square + "v 120 90 0\nv 120 120 0\nf 3 5 6\n"),
                            {{"vertices", 6}, {"faces", 3}, {"nonmanifold_vertices", 1}}));
    EXPECT_FALSE(countsAgree(folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
                             {{"vertices", 3}, {"faces", 1}, {"zero_area_triangles", 1}}));
}

}  // namespace
}  // namespace toile
