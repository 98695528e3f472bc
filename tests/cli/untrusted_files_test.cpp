// SPDX-License-Identifier: GPL-3.0-or-later
// What docs/untrusted-files.md promises: which files are opened, and within what limits.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/sanitized.h"
#include "core/project/project_file.h"
#include "tests/cli/run_program.h"
#include "tests/core/io/zip_archive.h"
#include "tests/core/support/shared_data.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

/// A square in metres: four corners as floats, six indices as 16 bits.
std::string squareBuffer() {
    std::string bytes;
    for (const float value : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    for (const std::uint16_t index : {0, 1, 2, 0, 2, 3}) {
        bytes.append(reinterpret_cast<const char*>(&index), sizeof index);
    }
    return bytes;
}

/// The square as glTF. @param nodes  the list of nodes, of which the first is the scene's
std::string gltf(const std::string& uri, const std::string& nodes = R"([{"mesh": 0}])",
                 const std::string& more = "") {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": )" +
           nodes + R"(, "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
               "min": [0, 0, 0], "max": [1, 1, 0]},
              {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteLength": 48},
                {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
"buffers": [{"byteLength": 60, "uri": ")" +
           uri + "\"}]" + more + "}";
}

/// What a program opened, as strace saw it.
struct Opened {
    int status = -1;
    std::string err;
    std::vector<std::string> read, written;

    /// The opened files that are in a folder.
    std::vector<std::string> in(const std::string& folder) const {
        std::vector<std::string> found;
        std::ranges::copy_if(read, std::back_inserter(found), [&folder](const std::string& path) {
            return path.find(folder) != std::string::npos;
        });
        return found;
    }
};

bool hasStrace() {
    static const bool isThere =
        std::system("strace -f -o /dev/null true >/dev/null 2>&1") == 0 && !isSanitized();
    return isThere;
}

Opened traced(const std::vector<std::string>& arguments) {
    const test::TemporaryFolder folder;
    const std::string log = (folder / "log").string();
    std::vector<std::string> words{"-f",   "-y", "-s",
                                   "4096", "-e", "trace=open,openat,openat2,creat",
                                   "-o",   log,  TOILE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const auto run = test::run("strace", words);
    Opened opened{run.status, run.err, {}, {}};
    std::istringstream lines(folder.read("log"));
    for (std::string line; std::getline(lines, line);) {
        // 12 openat(AT_FDCWD</garments>, "a.obj", O_RDONLY) = 3</garments/a.obj>
        const std::size_t result = line.rfind(") = ");
        const std::size_t path = line.find('<', result == std::string::npos ? line.size() : result);
        if (path != std::string::npos) {
            const std::string resolved = line.substr(path + 1, line.rfind('>') - path - 1);
            const bool writes = line.find("O_WRONLY") < result || line.find("O_RDWR") < result;
            (writes ? opened.written : opened.read).push_back(resolved);
        }
    }
    return opened;
}

#define TOILE_NEEDS_STRACE()            \
    if (!hasStrace()) {                 \
        GTEST_SKIP() << "needs strace"; \
    }

/// A folder of a stranger's files, with a folder beside it that they must not reach.
class UntrustedFiles : public testing::Test {
protected:
    UntrustedFiles() {
        fs::create_directories(folder_ / "given/below");
        fs::create_directory(folder_ / "secret");
        folder_.write("secret/s.bin", squareBuffer());
        folder_.write("secret/x.mtl", "newmtl denim\n");
        folder_.write("secret/x.obj", test::kTriangle);
        folder_.write("secret/x.usda", "#usda 1.0\n");
        folder_.write("given/s.bin", squareBuffer());
        folder_.write("given/below/s.bin", squareBuffer());
        fs::create_symlink("../secret/s.bin", folder_ / "given/link.bin");
        fs::create_directory_symlink("../secret", folder_ / "given/linked");
    }

    std::string given(const std::string& name, const std::string& text) {
        return folder_.write("given/" + name, text).string();
    }

    /// The file is read or refused, and nothing in the folder beside is opened.
    Opened expectConfined(const std::string& path) {
        Opened opened = traced({"info", path});
        EXPECT_TRUE(opened.status >= 0 && opened.status <= 3) << opened.err;
        EXPECT_FALSE(opened.in(fs::path(path).filename().string()).empty()) << "strace saw nothing";
        EXPECT_EQ(opened.in("/secret/"), std::vector<std::string>()) << path;
        return opened;
    }

    test::TemporaryFolder folder_;
};

TEST_F(UntrustedFiles, GltfBuffersAreReadInTheFolderAndBelowOnly) {
    TOILE_NEEDS_STRACE();
    const std::string outside = (folder_ / "secret/s.bin").string();
    const std::pair<const char*, std::string> refused[] = {
        {"up", gltf("../secret/s.bin")},
        {"escaped", gltf("%2e%2e/secret/s.bin")},
        {"slash", gltf("..%2Fsecret%2Fs.bin")},
        {"backslashes", gltf(R"(..\\secret\\s.bin)")},
        {"absolute", gltf(outside)},
        {"link", gltf("link.bin")},
        {"linkedFolder", gltf("linked/s.bin")},
        {"round", gltf("below/../../secret/s.bin")},
        {"twice", gltf("../secret/s.bin", R"([{"mesh": 0}])",
                       R"(, "buffers": [{"byteLength": 60, "uri": "s.bin"}])")},
        {"first", gltf("s.bin", R"([{"mesh": 0}])",
                       R"(, "buffers": [{"byteLength": 60, "uri": "../secret/s.bin"}])")}};
    for (const auto& [name, text] : refused) {
        SCOPED_TRACE(name);
        const Opened opened = expectConfined(given(std::string(name) + ".gltf", text));
        EXPECT_EQ(opened.status, 3);
        EXPECT_NE(opened.err.find(name), std::string::npos) << opened.err;
    }
    expectConfined(given("uri.gltf", gltf("file://" + outside)));
    EXPECT_EQ(expectConfined(given("beside.gltf", gltf("s.bin"))).status, 0);
    EXPECT_EQ(expectConfined(given("below.gltf", gltf("below/s.bin"))).status, 0);
}

TEST_F(UntrustedFiles, ContentNeverChoosesAnotherReader) {
    TOILE_NEEDS_STRACE();
    const std::string lightWave = "LWSC\n3\n\nLoadObjectLayer 1 ../secret/x.obj\n";
    const std::string obj = std::string("mtllib ../secret/x.mtl\n") + test::kTriangle;
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    for (const char* ending : {".glb", ".gltf", ".fbx", ".dae", ".3mf"}) {
        for (const auto& [content, text] :
             {std::pair("LightWave", lightWave), {"OBJ", obj}, {"PLY", ply}}) {
            SCOPED_TRACE(std::string(ending) + " " + content);
            const Opened opened = expectConfined(given(std::string("a") + ending, text));
            EXPECT_EQ(opened.status, 3);
            EXPECT_NE(opened.err.find(content), std::string::npos) << opened.err;
        }
    }
}

TEST_F(UntrustedFiles, MaterialsAndReferencesAreNotFollowed) {
    TOILE_NEEDS_STRACE();
    EXPECT_EQ(
        expectConfined(given("a.obj", std::string("mtllib ../secret/x.mtl\n") + test::kTriangle))
            .status,
        0);
    expectConfined(given("a.usda",
                         "#usda 1.0\n( subLayers = [@../secret/x.usda@] )\n"
                         "def Mesh \"m\" ( references = @../secret/x.usda@ ) {\n"
                         " int[] faceVertexCounts = [3]\n int[] faceVertexIndices = [0, 1, 2]\n"
                         " point3f[] points = [(0, 0, 0), (50, 0, 0), (0, 50, 0)]\n}\n"));
    expectConfined(
        folder_.write("given/a.zip", test::zipOf({{"../secret/x.obj", test::kTriangle}})).string());
}

TEST_F(UntrustedFiles, KnownAttacksStayInTheirFolder) {
    const fs::path attack = test::sharedFile("attack");
    TOILE_NEEDS_SHARED(attack);
    TOILE_NEEDS_STRACE();
    int tried = 0;
    for (const std::string part : {"gltf-outside", "any-format", "secret"}) {
        fs::create_directories(folder_ / part);
        for (const auto& entry : fs::directory_iterator(attack / part)) {
            fs::copy_file(entry.path(), folder_ / part / entry.path().filename(),
                          fs::copy_options::overwrite_existing);
        }
    }
    fs::create_symlink("../secret/s.bin", folder_ / "gltf-outside/link.bin");
    for (const char* part : {"gltf-outside", "any-format"}) {
        for (const auto& entry : fs::directory_iterator(folder_ / part)) {
            if (entry.path().extension() != ".bin") {
                EXPECT_EQ(expectConfined(entry.path().string()).status, 3);
                ++tried;
            }
        }
    }
    EXPECT_GE(tried, 6);
}

TEST_F(UntrustedFiles, CommandsWriteOnlyWhatTheyAreToldTo) {
    TOILE_NEEDS_STRACE();
    fs::create_directory(folder_ / "out");
    Project project;
    project.files = {{folder_ / "secret/x.obj"}};
    project.loading.unit = LengthUnit::Millimetre;
    ASSERT_TRUE(writeProject(folder_ / "given/a.toile", project));
    folder_.write("given/list.txt", (folder_ / "secret/x.obj").string() + "\n");
    const std::string out = (folder_ / "out").string();
    const std::vector<std::string> commands[] = {
        {"flatten", (folder_ / "given/a.toile").string(), "-o", out + "/a.svg"},
        {"batch", (folder_ / "given/list.txt").string(), "-o", out + "/batch", "--unit", "mm"}};
    for (const auto& command : commands) {
        const Opened opened = traced(command);
        EXPECT_EQ(opened.status, 0) << opened.err;
        // A project and a list may name files anywhere, and these are read.
        EXPECT_FALSE(opened.in("/secret/x.obj").empty()) << command.front();
        for (const std::string& path : opened.written) {
            EXPECT_TRUE(path.starts_with(out) || path.starts_with("/dev/") ||
                        path.starts_with("pipe:"))
                << path;
        }
    }
    // A line of a list cannot say where to write.
    folder_.write("given/list.txt",
                  (folder_ / "secret/x.obj").string() + " -o " + out + "/b.svg\n");
    EXPECT_NE(
        test::toileRun({"batch", (folder_ / "given/list.txt").string(), "-o", out + "/c"}).status,
        0);
    EXPECT_FALSE(fs::exists(folder_ / "out/b.svg"));
}

/// What a run took, with its child processes.
struct Cost {
    int status = -1;
    double seconds = 0, megabytes = 0;
    std::string err;
};

Cost costOf(const std::string& path) {
    const test::TemporaryFolder folder;
    const std::string err = (folder / "err").string();
    const pid_t child = fork();
    if (child == 0) {
        const int file = open(err.c_str(), O_WRONLY | O_CREAT, 0600);
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(file, STDERR_FILENO);
        dup2(nowhere, STDOUT_FILENO);
        execl(TOILE_PROGRAM, TOILE_PROGRAM, "info", path.c_str(), nullptr);
        _exit(127);
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    const auto secondsOf = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime),
            static_cast<double>(usage.ru_maxrss) / 1000, folder.read("err")};
}

/// The limits that docs/untrusted-files.md states for files below 5 MB.
void expectCheap(const std::string& path, bool isRefused) {
    SCOPED_TRACE(path);
    const Cost cost = costOf(path);
    if (isRefused) {
        EXPECT_EQ(cost.status, 3) << cost.err;
    }
    EXPECT_TRUE(cost.status >= 0 && cost.status <= 3) << cost.err;
    EXPECT_LE(std::count(cost.err.begin(), cost.err.end(), '\n'), 20);
    if (!isSanitized()) {
        EXPECT_LT(cost.megabytes, 1000);
        EXPECT_LT(cost.seconds, 10);
    }
}

/// Nodes of which each one but the last has the next as its child twice: 2^count placements.
std::string sharedNodes(int count) {
    std::string nodes = "[";
    for (int k = 1; k < count; ++k) {
        const std::string next = std::to_string(k);
        nodes += R"({"children": [)" + next + ", " + next + "]}, ";
    }
    return nodes + R"({"mesh": 0}])";
}

TEST_F(UntrustedFiles, NodesThatAreSharedManyTimesAreRefused) {
    for (const int count : {18, 22, 40}) {
        expectCheap(given("nodes.gltf", gltf("s.bin", sharedNodes(count))), true);
    }
}

/// One square, placed so many times.
std::string manyNodes(int count) {
    std::string children, nodes;
    for (int k = 1; k <= count; ++k) {
        children += (k > 1 ? "," : "") + std::to_string(k);
        nodes += R"(,{"mesh":0})";
    }
    return R"([{"children": [)" + children + "]}" + nodes + "]";
}

TEST_F(UntrustedFiles, AMeshThatIsPlacedManyTimesIsCountedBeforeItIsCopied) {
    const std::string path = given("many.gltf", gltf("s.bin", manyNodes(20'000)));
    expectCheap(path, true);
    EXPECT_NE(costOf(path).err.find("places 20000 objects"), std::string::npos);
    EXPECT_EQ(costOf(given("some.gltf", gltf("s.bin", manyNodes(100)))).status, 0);
}

TEST_F(UntrustedFiles, AStatedUnitWithAnUnlikelySizeIsDoubtedByInfoAndFlatten) {
    const std::string path =
        given("a.gltf", gltf("s.bin", R"([{"mesh": 0, "scale": [40, 40, 40]}])"));
    for (const auto& command : {std::vector<std::string>{"info", path},
                                {"flatten", path, "-o", (folder_ / "a.svg").string()}}) {
        const auto run = test::toileRun(command);
        EXPECT_NE(run.err.find("40000 mm is unusual"), std::string::npos) << run.err;
        auto stated = command;
        stated.insert(stated.end(), {"--unit", "m"});
        EXPECT_EQ(test::toileRun(stated).err.find("unusual"), std::string::npos);
    }
}

class UntrustedFilesSlow : public UntrustedFiles {};

TEST_F(UntrustedFilesSlow, AMeshThatIsPlacedVeryOftenIsRefused) {
    constexpr int kTimes = 200'000;
    expectCheap(given("many.gltf", gltf("s.bin", manyNodes(kTimes))), true);
    std::string items;
    for (int k = 0; k < kTimes; ++k) {
        items += R"(<item objectid="1"/>)";
    }
    const std::string model =
        R"(<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<resources><object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/>
<vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices><triangles>
<triangle v1="0" v2="1" v3="2"/></triangles></mesh></object></resources><build>)" +
        items + "</build></model>";
    const std::string relations =
        R"(<Relationships><Relationship Target="/3D/3dmodel.model" Id="r" )"
        R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)";
    expectCheap(
        given("many.3mf", test::zipOf({{"_rels/.rels", relations}, {"3D/3dmodel.model", model}})),
        true);
}

TEST_F(UntrustedFiles, ArchivesAreCheap) {
    std::vector<test::ZipEntry> many(1000, {"a.obj", test::kTriangle});
    for (std::size_t k = 0; k < many.size(); ++k) {
        many[k].name = std::to_string(k) + ".obj";
    }
    const std::string archive = given("many.zip", test::zipOf(many));
    expectCheap(archive, false);
    if (!isSanitized()) {
        EXPECT_LT(costOf(archive).megabytes, 200);  // not a megabyte for each entry
    }
    for (test::ZipEntry& entry : many) {
        entry.statedSize = 1'000'000;
        entry.method = 8;
    }
    expectCheap(given("bomb.zip", test::zipOf(many)), true);
}

TEST_F(UntrustedFilesSlow, KnownAttacksAreCheap) {
    const fs::path attack = test::sharedFile("attack");
    TOILE_NEEDS_SHARED(attack);
    for (const char* part : {"assimp-time", "assimp-memory", "zip"}) {
        for (const auto& entry : fs::directory_iterator(attack / part)) {
            if (entry.path().extension() != ".bin") {
                expectCheap(entry.path().string(), false);
            }
        }
    }
}

}  // namespace
}  // namespace toile
