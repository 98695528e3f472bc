// SPDX-License-Identifier: GPL-3.0-or-later
// toile batch: every garment once, whatever is bad, killed or run again.
#include "app/cli/batch.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/sanitized.h"
#include "core/project/project_file.h"
#include "tests/cli/run_program.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// A folder with garments and a list of them.
struct Bench {
    test::TemporaryFolder folder;
    std::string list;

    std::string garment(const std::string& name, const std::string& mesh,
                        const std::string& words = "") {
        const std::string path = folder.write(name, mesh).string();
        list += path + words + '\n';
        folder.write("shard.txt", list);
        return path;
    }
    std::vector<std::string> command(const std::string& out,
                                     const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"batch",  (folder / "shard.txt").string(),
                                       "-o",     (folder / out).string(),
                                       "--unit", "mm"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    test::ProgramRun run(const std::string& out, const std::vector<std::string>& more = {}) const {
        return test::toileRun(command(out, more));
    }
    std::vector<nlohmann::json> records(const std::string& out) const {
        std::vector<nlohmann::json> found;
        std::istringstream lines(folder.read(out + "/shard.jsonl"));
        for (std::string line; std::getline(lines, line);) {
            found.push_back(nlohmann::json::parse(line));
        }
        return found;
    }
    /// All that is to be the same at every run.
    std::string lasting(const std::string& out) const {
        std::string text;
        for (nlohmann::json record : records(out)) {
            record.erase("cost");
            text += record.dump() + '\n';
            for (const std::string output : record["outputs"]) {
                if (!output.ends_with(".json")) {  // a report has times
                    const std::string name = record["name"];
                    text += folder.read(out + '/' + name + '/' + output);
                }
            }
        }
        return text;
    }
    bool hasParts(const std::string& out) const {
        return std::ranges::any_of(fs::directory_iterator(folder / out), [](const auto& entry) {
            return entry.path().extension() == ".part";
        });
    }
};

/// A panel that is a little higher than the last.
std::string panelOf(int height) {
    const std::string top = std::to_string(height);
    return "v 0 0 0\nv 300 0 0\nv 300 " + top + " 0\nv 0 " + top + " 0\no flap\nf 1 2 3\nf 1 3 4\n";
}

/// Kills the program with a signal once something of the first garment is there.
int statusAfter(int signal, const Bench& bench, const std::string& out) {
    std::vector<std::string> words = bench.command(out);
    words.insert(words.begin(), TOILE_PROGRAM);
    std::vector<char*> argv;
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    pid_t program = 0;
    if (posix_spawn(&program, TOILE_PROGRAM, nullptr, nullptr, argv.data(), environ) != 0) {
        return -1;
    }
    const fs::path folder = bench.folder / out;
    int status = 0;
    while (waitpid(program, &status, WNOHANG) == 0) {
        std::error_code ignored;
        if (fs::exists(folder, ignored) && !fs::is_empty(folder, ignored)) {
            kill(program, signal);
            waitpid(program, &status, 0);
            break;
        }
        usleep(1000);
    }
    return status;
}

TEST(Batch, EveryGarmentIsThereAndABadFileStopsNothing) {
    Bench bench;
    bench.garment("a.obj", test::kPanel);
    bench.garment("empty.obj", "");
    bench.garment("ball.obj", test::kBall);
    bench.garment("notes.txt", "no mesh");
    bench.garment("b.obj", panelOf(410));
    const auto run = bench.run("out", {"--formats", "svg,json,obj"});
    EXPECT_EQ(run.status, 1) << run.err;
    EXPECT_NE(run.out.find("5 garments: 2 done"), std::string::npos) << run.out;
    const auto records = bench.records("out");
    ASSERT_EQ(records.size(), 5U);
    EXPECT_EQ(records[0]["status"], "done");
    EXPECT_EQ(records[0]["pieces"], 1);
    EXPECT_EQ(records[0]["triangles"], 2);
    EXPECT_LT(records[0]["strain_max"].get<double>(), 1e-9);
    EXPECT_TRUE(records[0]["error"].is_null());
    EXPECT_GT(records[0]["cost"]["peak_mib"].get<double>(), 0);
    EXPECT_EQ(records[1]["status"], "failed");
    EXPECT_EQ(records[1]["error"]["code"], "no-geometry");
    EXPECT_EQ(records[2]["status"], "failed");
    EXPECT_EQ(records[2]["error"]["code"], "closed-surface");
    EXPECT_EQ(records[2]["error"]["subject"], "ball");
    EXPECT_EQ(records[3]["error"]["code"], "unknown-format");
    EXPECT_EQ(records[4]["status"], "done");
    const std::string name = records[0]["name"];
    EXPECT_TRUE(name.starts_with("a-"));
    for (const char* file : {"pattern.svg", "pattern.json", "pattern.obj", "garment.json"}) {
        EXPECT_FALSE(bench.folder.read("out/" + name + '/' + file).empty()) << file;
    }
    EXPECT_FALSE(bench.hasParts("out"));
}

TEST(Batch, WhatIsFinishedIsSkippedByContentAndOptions) {
    Bench bench;
    bench.garment("a.obj", test::kPanel);
    bench.garment("b.obj", panelOf(410), "\t--method\tlscm");
    EXPECT_EQ(bench.run("out").status, 0);
    EXPECT_EQ(bench.records("out").size(), 2U);
    EXPECT_EQ(bench.records("out")[1]["options"],
              nlohmann::json({"--unit", "mm", "--method", "lscm"}));
    const std::string before = bench.folder.read("out/shard.jsonl");
    EXPECT_NE(bench.run("out").out.find("2 finished before"), std::string::npos);
    EXPECT_EQ(bench.folder.read("out/shard.jsonl"), before);
    // Threads and limits change nothing of the result; formats and options do.
    EXPECT_NE(bench.run("out", {"--threads", "2", "--limit", "50"}).out.find("2 finished before"),
              std::string::npos);
    EXPECT_NE(bench.run("out", {"--formats", "svg"}).out.find("0 finished before"),
              std::string::npos);
    EXPECT_NE(bench.run("out", {"--formats", "svg", "--true"}).out.find("0 finished before"),
              std::string::npos);
    bench.folder.write("a.obj", panelOf(420));
    EXPECT_NE(bench.run("out", {"--formats", "svg"}).out.find("1 finished before"),
              std::string::npos);
}

TEST(Batch, KilledAndRunAgainItIsAsIfNothingHadBeen) {
    Bench bench;
    for (int k = 0; k < 6; ++k) {
        bench.garment("g" + std::to_string(k) + ".obj", panelOf(400 + k));
    }
    EXPECT_EQ(bench.run("undisturbed").status, 0);
    const std::string whole = bench.lasting("undisturbed");
    EXPECT_EQ(bench.records("undisturbed").size(), 6U);
    for (const int signal : {SIGKILL, SIGTERM}) {
        const std::string out = "signal" + std::to_string(signal);
        const int status = statusAfter(signal, bench, out);
        if (signal == SIGTERM) {
            EXPECT_TRUE(WIFEXITED(status));
            EXPECT_TRUE(WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == 128 + SIGTERM);
            EXPECT_FALSE(bench.hasParts(out));
        }
        EXPECT_EQ(bench.run(out).status, 0);
        EXPECT_EQ(bench.lasting(out), whole);
        EXPECT_FALSE(bench.hasParts(out));
    }
}

TEST(Batch, TwoAtOnceDoEveryGarmentOnce) {
    Bench bench;
    for (int k = 0; k < 6; ++k) {
        bench.garment("g" + std::to_string(k) + ".obj", panelOf(400 + k));
    }
    std::string both;
    for (const std::string& word : bench.command("out")) {
        both += " '" + word + "'";
    }
    const auto run = test::run(
        "/bin/sh", {"-c", "p='" TOILE_PROGRAM "'; \"$p\"" + both + " & \"$p\"" + both + " & wait"});
    EXPECT_EQ(run.err, "");
    std::size_t before = 0, at = 0;
    while ((at = run.out.find(": finished before, done", at)) != std::string::npos) {
        ++before;
        ++at;
    }
    EXPECT_EQ(before, 6U) << run.out;
    EXPECT_EQ(bench.records("out").size(), 6U);
}

/// A dome that takes some tenths of a second: long beyond what a process waits for its turn.
std::string domeOf(int side) {
    std::string text;
    for (int row = 0; row <= side; ++row) {
        for (int k = 0; k <= side; ++k) {
            const double x = k - side / 2.0, y = row - side / 2.0;
            text += "v " + std::to_string(x) + " " + std::to_string(y) + " " +
                    std::to_string(-(x * x + y * y) / (2.0 * side)) + "\n";
        }
    }
    for (int row = 0; row < side; ++row) {
        for (int k = 1; k <= side; ++k) {
            const int low = row * (side + 1) + k, high = low + side + 1;
            text += "f " + std::to_string(low) + " " + std::to_string(low + 1) + " " +
                    std::to_string(high + 1) + " " + std::to_string(high) + "\n";
        }
    }
    return text;
}

TEST(Batch, WhatTookTooLongIsTriedAgainNextTime) {
    Bench bench;
    bench.garment("a.obj", domeOf(60));
    EXPECT_EQ(bench.run("out", {"--limit", "0.001"}).status, 1);
    EXPECT_EQ(bench.records("out")[0]["error"]["code"], "timed-out");
    EXPECT_EQ(bench.records("out")[0]["error"]["again"], true);
    EXPECT_EQ(bench.run("out").status, 0);
    EXPECT_EQ(bench.records("out")[0]["status"], "done");
}

#ifdef __linux__
TEST(Batch, MemoryHasABound) {
    if (isSanitized()) {
        GTEST_SKIP() << "a sanitizer has more memory mapped than any bound";
    }
    Bench bench;
    bench.garment("a.obj", test::kPanel);
    // It is the garment's: what the program and the BLAS have beside it does not count.
    EXPECT_EQ(bench.run("out", {"--memory", "20"}).status, 0);
    const auto statusOf = [](std::size_t mib, int limit) {
        const app::BatchSignals signals;
        return app::inOwnProcess(
                   [mib] {
                       void* volatile taken = std::malloc(mib << 20U);
                       const bool isRefused = taken == nullptr;
                       std::free(taken);
                       return isRefused ? 1 : 0;
                   },
                   {0, limit, 1})
            .status;
    };
    EXPECT_EQ(statusOf(4000, 1000), 1);
    EXPECT_EQ(statusOf(900, 1000), 0);
    EXPECT_EQ(statusOf(4000, 0), 0);
    // A file that is larger, and of which nothing is on the disk.
    fs::resize_file(bench.garment("large.obj", ""), std::uintmax_t{1900} << 20U);
    EXPECT_EQ(bench.run("out", {"--memory", "20"}).status, 1);
    const auto large = bench.records("out")[1];
    EXPECT_NE(large["error"]["message"].get<std::string>().find("memory"), std::string::npos)
        << large.dump();
}
#endif

TEST(Batch, GarmentsOfEqualContentShareAFolderAndHaveARecordEach) {
    Bench bench;
    bench.garment("a.obj", test::kPanel);
    fs::create_directory(bench.folder / "other");
    const std::string twin = bench.garment("other/a.obj", test::kPanel);
    for (const char* before : {"0", "2"}) {
        const auto run = bench.run("out");
        EXPECT_EQ(run.status, 0);
        EXPECT_NE(run.out.find("2 garments: 2 done"), std::string::npos) << run.out;
        EXPECT_NE(run.out.find(std::string(before) + " finished before"), std::string::npos);
        const auto records = bench.records("out");
        ASSERT_EQ(records.size(), 2U);
        EXPECT_EQ(records[0]["name"], records[1]["name"]);
        EXPECT_EQ(records[1]["input"], twin);
    }
    // Each line is told as the list has it, whoever came first.
    bench.folder.write("shard.txt", twin + '\n');
    EXPECT_EQ(bench.run("out").status, 0);
    EXPECT_EQ(bench.records("out")[0]["input"], twin);
}

TEST(Batch, APipeIsNoGarmentAndStopsNothing) {
    Bench bench;
    const std::string pipe = (bench.folder / "pipe.obj").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    bench.garment("a.obj", test::kPanel, "\t--seams\t" + pipe);
    bench.garment("b.obj", test::kPanel);
    bench.folder.write("shard.txt", pipe + '\n' + bench.list);
    EXPECT_EQ(bench.run("out").status, 1);
    const auto records = bench.records("out");
    ASSERT_EQ(records.size(), 3U);
    EXPECT_EQ(records[0]["error"]["code"], "file-unreadable");
    EXPECT_EQ(records[1]["error"]["code"], "file-unreadable");
    EXPECT_TRUE(records[1]["hash"].is_null());
    EXPECT_EQ(records[2]["status"], "done");
}

TEST(Batch, AListMayHaveAByteOrderMarkAndBlankLines) {
    Bench bench;
    const std::string path = bench.garment("a.obj", test::kPanel);
    bench.folder.write("shard.txt", "\xEF\xBB\xBF" + path + "\r\n  \n\t\r\n# " + path + "\n");
    EXPECT_EQ(bench.run("out").status, 0);
    ASSERT_EQ(bench.records("out").size(), 1U);
    EXPECT_EQ(bench.records("out")[0]["input"], path);
}

TEST(Batch, WhatIsOfATerminalIsNoWordOfALine) {
    Bench bench;
    const std::string stray = (bench.folder / "stray.json").string();
    for (const std::string& words :
         {"-o\t" + stray, "--report\t" + stray, std::string("--ledger"),
          std::string("--fail-on\tdoubt"), std::string("--threads\t2")}) {
        bench.garment("a.obj", test::kPanel, '\t' + words);
    }
    EXPECT_EQ(bench.run("out").status, 1);
    const auto records = bench.records("out");
    ASSERT_EQ(records.size(), 5U);
    for (const auto& record : records) {
        EXPECT_EQ(record["error"]["code"], "wrong-usage") << record.dump();
        EXPECT_EQ(record["error"]["again"], false);
    }
    EXPECT_FALSE(fs::exists(stray));
}

TEST(BatchProcess, WhatIsIgnoredFromTheStartStaysIgnored) {
    const auto before = std::signal(SIGHUP, SIG_IGN);
    {
        const app::BatchSignals signals;
        raise(SIGHUP);
        EXPECT_EQ(app::BatchSignals::received(), 0);
        const auto end = app::inOwnProcess([] { return raise(SIGHUP) == 0 ? 7 : 8; }, {});
        EXPECT_EQ(end.status, 7);
        raise(SIGTERM);
        EXPECT_EQ(app::BatchSignals::received(), SIGTERM);
    }
    EXPECT_EQ(std::signal(SIGHUP, before), SIG_IGN);
}

TEST(BatchProcess, AChildThatEndsOfCtrlCFirstIsInterruptedAndHasNoFault) {
    const app::BatchSignals signals;
    const pid_t parent = getpid();
    const auto end = app::inOwnProcess(
        [parent] {  // as from a terminal, which sends it to both
            kill(parent, SIGINT);
            return raise(SIGINT);
        },
        {});
    EXPECT_TRUE(end.isInterrupted);
}

TEST(BatchProcess, ATextComesBack) {
    const app::BatchSignals signals;
    std::string text;
    EXPECT_EQ(app::textOfOwnProcess([] { return std::string("found"); }, {}, text).signal, 0);
    EXPECT_EQ(text, "found");
    const auto end = app::textOfOwnProcess(
        [] {
            raise(SIGKILL);
            return std::string("lost");
        },
        {}, text);
    EXPECT_EQ(end.signal, SIGKILL);
    EXPECT_EQ(text, "");
}

TEST(BatchFolder, WhereItCannotBeOpenedThatIsSaid) {
    const test::TemporaryFolder folder;
    app::BatchFolder made(folder / "", "garment");
    rlimit files{};
    getrlimit(RLIMIT_NOFILE, &files);
    const rlimit none{0, files.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
    int looks = 0;
    const auto claimed = made.claim([&looks] { return ++looks > 100; });
    setrlimit(RLIMIT_NOFILE, &files);
    ASSERT_FALSE(claimed);
    EXPECT_EQ(claimed.error().code, ErrorCode::FileUnwritable);
    EXPECT_EQ(looks, 1);
}

TEST(Batch, AProjectIsKnownByItsMeshesToo) {
    Bench bench;
    const std::string mesh = bench.folder.write("flap.obj", test::kPanel).string();
    const std::string project = (bench.folder / "flap.toile").string();
    Project made;
    made.files = {{mesh}};
    made.loading.unit = LengthUnit::Millimetre;
    ASSERT_TRUE(writeProject(project, made));
    bench.folder.write("shard.txt", project + '\n' + bench.folder.write("b.toile", "{}").string());
    const auto run = [&] {
        return test::toileRun({"batch", (bench.folder / "shard.txt").string(), "-o",
                               (bench.folder / "out").string()});
    };
    EXPECT_EQ(run().status, 1);
    EXPECT_EQ(bench.records("out")[0]["status"], "done");
    EXPECT_EQ(bench.records("out")[1]["error"]["code"], "malformed-project");
    EXPECT_NE(run().out.find("2 finished before"), std::string::npos);
    bench.folder.write("flap.obj", panelOf(430));
    EXPECT_NE(run().out.find("1 finished before"), std::string::npos);
}

TEST(Batch, SaysWhatIsWrongWithItsOptions) {
    Bench bench;
    bench.garment("a.obj", test::kPanel, "\t--wrong");
    bench.garment("b.obj", test::kPanel, "\t--unit\tcm");  // which is mm for all
    EXPECT_EQ(bench.run("out", {"--method", "ironing"}).status, 2);
    EXPECT_EQ(bench.run("out", {"--formats", "svg,doc"}).status, 2);
    EXPECT_EQ(test::toileRun({"batch", "/no/list", "-o", (bench.folder / "o").string()}).status, 3);
    EXPECT_EQ(bench.run("out").status, 1);
    EXPECT_EQ(bench.records("out")[0]["error"]["code"], "wrong-usage");
    const auto again = bench.records("out")[1]["error"];
    EXPECT_EQ(again["code"], "wrong-usage");
    EXPECT_EQ(again["message"], "--unit is set for all garments already; leave it out here");
    // A switch that is said again says the same.
    EXPECT_EQ(bench.run("switch", {"--weld", "--true"}).status, 1);
    bench.folder.write("shard.txt", (bench.folder / "a.obj").string() + "\t--weld\n");
    EXPECT_EQ(bench.run("switch", {"--weld", "--true"}).status, 0);
}

TEST(Batch, EmptyWordsOfALineAreSkippedAndACommentMayStandFurtherRight) {
    Bench bench;
    const std::string path = bench.garment("a.obj", test::kPanel, "\t\t--split\t \tuv\t");
    bench.folder.write("shard.txt", bench.list + "  # more of them\n\t#\n");
    const auto run = bench.run("out");
    EXPECT_EQ(run.status, 0) << run.out;
    const auto records = bench.records("out");
    ASSERT_EQ(records.size(), 1U);
    EXPECT_EQ(records[0]["input"], path);
    EXPECT_EQ(records[0]["options"], nlohmann::json({"--unit", "mm", "--split", "uv"}));
}

TEST(Batch, AListOfTheSameNameDoesNotTakeTheRecordsOfAnother) {
    Bench bench;
    const std::string mesh = bench.folder.write("a.obj", test::kPanel).string();
    const fs::path folder = bench.folder / "";
    fs::create_directories(folder / "one");
    fs::create_directories(folder / "two");
    const std::string one = bench.folder.write("one/shirts.txt", mesh + '\n').string();
    const std::string two = bench.folder.write("two/shirts.txt", mesh + '\n' + mesh).string();
    const auto run = [&](const std::string& list) {
        return test::toileRun({"batch", list, "-o", (bench.folder / "out").string()});
    };
    EXPECT_EQ(run(one).status, 0);
    const std::string records = bench.folder.read("out/shirts.jsonl");
    const auto refused = run(two);
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find(one), std::string::npos) << refused.err;
    EXPECT_EQ(bench.folder.read("out/shirts.jsonl"), records);
    // By another way to it, or with other lines, it is the same list.
    bench.folder.write("one/shirts.txt", mesh + '\n' + mesh + '\n' + mesh + '\n');
    EXPECT_EQ(run((folder / "two/../one/shirts.txt").string()).status, 0);
    // One that is gone needs them no more.
    fs::remove(one);
    EXPECT_EQ(run(two).status, 0);
    // A list in the folder itself keeps its records too, and goes where the folder goes.
    fs::create_directories(folder / "out/lists");
    const std::string own = bench.folder.write("out/lists/own.txt", mesh + '\n').string();
    EXPECT_EQ(run(own).status, 0);
    EXPECT_TRUE(fs::exists(folder / "out/own.jsonl"));
    const std::string late = bench.folder.write("two/own.txt", mesh + '\n').string();
    EXPECT_EQ(run(late).status, 2);
    fs::copy(folder / "out", folder / "copy", fs::copy_options::recursive);
    EXPECT_EQ(test::toileRun({"batch", (folder / "copy/lists/own.txt").string(), "-o",
                              (folder / "copy").string()})
                  .status,
              0);
}

TEST(Batch, FilesOfOthersBesideTheRecordsStay) {
    Bench bench;
    const std::string mesh = bench.folder.write("a.obj", test::kPanel).string();
    const fs::path out = bench.folder / "out";
    fs::create_directories(out);
    bench.folder.write("out/shirts.list", mesh + '\n');
    bench.folder.write("out/shirts.jsonl.of", mesh + '\n');
    const std::string list = bench.folder.write("shirts.txt", mesh + '\n').string();
    const auto refused = test::toileRun({"batch", list, "-o", out.string()});
    EXPECT_EQ(refused.status, 2);
    EXPECT_NE(refused.err.find("shirts.jsonl.of is not "), std::string::npos) << refused.err;
    EXPECT_EQ(bench.folder.read("out/shirts.jsonl.of"), mesh + '\n');
    fs::remove(out / "shirts.jsonl.of");
    EXPECT_EQ(test::toileRun({"batch", list, "-o", out.string()}).status, 0);
    EXPECT_EQ(bench.folder.read("out/shirts.list"), mesh + '\n');
    // The list itself.
    const std::string self = bench.folder.write("out/self.jsonl", mesh + '\n').string();
    EXPECT_EQ(test::toileRun({"batch", self, "-o", out.string()}).status, 2);
    EXPECT_EQ(bench.folder.read("out/self.jsonl"), mesh + '\n');
}

TEST(Batch, AMeshIsNoListOfGarments) {
    Bench bench;
    const std::string mesh = bench.garment("a.obj", test::kPanel);
    const std::string hidden = bench.folder.write("a.txt", test::kPanel).string();
    const std::string out = (bench.folder / "out").string();
    for (const std::string& list : {mesh, hidden}) {
        const auto run = test::toileRun({"batch", list, "-o", out});
        EXPECT_EQ(run.status, 2);
        EXPECT_NE(run.err.find("list of garments"), std::string::npos) << run.err;
        EXPECT_FALSE(fs::exists(out));
    }
    // A list of files that are gone is one.
    const std::string gone = bench.folder.write("gone.txt", "/no/garment.obj\n").string();
    EXPECT_EQ(test::toileRun({"batch", gone, "-o", out}).status, 1);
    EXPECT_NE(bench.folder.read("out/gone.jsonl").find("file-unreadable"), std::string::npos);
}

TEST(Batch, ALineMayNameFurtherFilesOfItsGarment) {
    Bench bench;
    const std::string back = bench.folder.write("back.obj", panelOf(410)).string();
    bench.garment("front.obj", test::kPanel, '\t' + back);
    EXPECT_EQ(bench.run("out").status, 0);
    EXPECT_EQ(bench.records("out")[0]["pieces"], 2);
    bench.folder.write("back.obj", panelOf(420));
    EXPECT_NE(bench.run("out").out.find("0 finished before"), std::string::npos);
}

}  // namespace
}  // namespace toile
