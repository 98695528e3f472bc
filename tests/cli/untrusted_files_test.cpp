// SPDX-License-Identifier: GPL-3.0-or-later
// What docs/untrusted-files.md promises: which files are opened, and within what limits. This file
// is long because it has the tests of one page: a file of each format, and a run of each command.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/sanitized.h"
#include "core/project/project_file.h"
#include "tests/cli/run_program.h"
#include "tests/core/io/zip_archive.h"
#include "tests/core/support/generator.h"
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

/// Runs the program.
/// @param variables  of its environment: "NAME=value"
/// @param input      a file as its standard input; empty: that of the test
Opened traced(const std::vector<std::string>& arguments,
              const std::vector<std::string>& variables = {}, const std::string& input = "") {
    const test::TemporaryFolder folder;
    const std::string log = (folder / "log").string();
    std::vector<std::string> words{
        "-f", "-y", "-s", "4096", "-e", "trace=open,openat,openat2,creat", "-o", log};
    for (const std::string& variable : variables) {
        words.insert(words.end(), {"-E", variable});
    }
    if (!input.empty()) {
        words.insert(words.end(), {"sh", "-c", R"(exec "$0" "$@" <")" + input + '"'});
    }
    words.emplace_back(TOILE_PROGRAM);
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
    /// @param command  that reads it, before and behind its name
    Opened expectConfined(const std::string& path, std::vector<std::string> command = {"info"},
                          const std::vector<std::string>& options = {}) {
        command.push_back(path);
        command.insert(command.end(), options.begin(), options.end());
        Opened opened = traced(command);
        EXPECT_TRUE(opened.status >= 0 && opened.status <= 3) << opened.err;
        EXPECT_FALSE(opened.in(fs::path(path).filename().string()).empty()) << "strace saw nothing";
        EXPECT_EQ(opened.in("/secret/"), std::vector<std::string>()) << path;
        return opened;
    }

    /// Runs it, and expects that it writes those files and folders, and beside them none but parts.
    void expectWrites(const std::vector<std::string>& command,
                      const std::vector<std::string>& files) {
        const std::string out = (folder_ / "out/").string();
        fs::remove_all(out);
        fs::create_directory(out);
        const Opened opened = traced(command);
        SCOPED_TRACE(command.front() + ": " + opened.err);
        EXPECT_EQ(opened.status, 0);
        for (const std::string& path : opened.written) {
            EXPECT_TRUE(path.starts_with("/dev/") || path.starts_with("pipe:") ||
                        (!files.empty() && path.starts_with(out)))
                << path;
        }
        std::set<std::string> found, expected(files.begin(), files.end());
        for (const auto& entry : fs::directory_iterator(out)) {
            found.insert(entry.path().string());
        }
        EXPECT_EQ(found, expected);
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
    const std::string corners = "0 0 0\n300 0 0\n0 400 0\n";
    for (const auto& [name, text] :
         {std::pair("a.ply",
                    "ply\nformat ascii 1.0\ncomment TextureFile ../secret/x.obj\n"
                    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                    "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                        corners + "3 0 1 2\n"),
          {"a.off", "OFF\n# ../secret/x.obj\n3 1 0\n" + corners + "3 0 1 2\n"},
          {"a.stl",
           "solid ../secret/x.obj\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
           "vertex 300 0 0\nvertex 0 400 0\nendloop\nendfacet\nendsolid x\n"}}) {
        EXPECT_EQ(expectConfined(given(name, text)).status, 0) << name;
    }
}

/// The same text so many times.
std::string times(std::size_t count, const std::string& text) {
    std::string all;
    for (std::size_t k = 0; k < count; ++k) {
        all += text;
    }
    return all;
}

/// Squares of some mm as polylines of a DXF file.
std::string dxfSquares(int count, double size, double step) {
    std::ostringstream squares;
    for (int k = 0; k < count; ++k) {
        const double x = k % 200 * step, y = std::floor(k / 200) * step;
        squares << "0\nLWPOLYLINE\n8\n1\n90\n4\n70\n1\n";
        for (const auto& [dx, dy] : {std::pair(0., 0.), {size, 0.}, {size, size}, {0., size}}) {
            squares << "10\n" << x + dx << "\n20\n" << y + dy << '\n';
        }
    }
    return squares.str();
}

std::string dxf(const std::string& entities, const std::string& blocks = "") {
    return "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities +
           "0\nENDSEC\n0\nEOF\n";
}

std::string svg(const std::string& content, const std::string& before = "") {
    return before +
           R"(<svg xmlns="http://www.w3.org/2000/svg" width="300mm" viewBox="0 0 300 300">)" +
           content + R"(<path id="a" d="M0 0H300V300H0Z"/></svg>)";
}

/// GarmentCode of triangles, with more members of the pattern.
std::string garmentCode(int count, const std::string& more = "") {
    std::string panels;
    for (int k = 0; k < count; ++k) {
        panels += (k == 0 ? "\"p" : ", \"p") + std::to_string(k) +
                  R"(": {"vertices": [[0, 0], [30, 0], [0, 40]], "translation": [0, 0, 0],
"rotation": [0, 0, 0], "edges": [{"endpoints": [0, 1]}, {"endpoints": [1, 2]}, {"endpoints": [2, 0]}]})";
    }
    return R"({"pattern": {"panels": {)" + panels + R"(}, "stitches": [])" + more +
           R"(}, "properties": {"units_in_meter": 100}})";
}

TEST_F(UntrustedFiles, PatternsHidesInstancesAndSeamsOpenNothingElse) {
    TOILE_NEEDS_STRACE();
    const std::string drawing =
        dxf("0\nINSERT\n2\nother\n10\n0\n20\n0\n0\nIMAGE\n340\n1A\n" + dxfSquares(1, 300, 0) +
                "0\nENDSEC\n0\nSECTION\n2\nOBJECTS\n0\nIMAGEDEF\n5\n1A\n1\n../secret/x.obj\n",
            "0\nBLOCK\n2\nother\n70\n4\n1\n../secret/x.dxf\n10\n0\n20\n0\n0\nENDBLK\n");
    const std::string picture =
        svg("<style>@import url(../secret/x.css);</style><image href=\"../secret/x.obj\"/>"
            "<use href=\"../secret/x.svg#a\"/><text>&x;</text>",
            "<?xml version=\"1.0\"?><?xml-stylesheet href=\"../secret/x.css\"?>"
            "<!DOCTYPE svg [<!ENTITY x SYSTEM \"../secret/x.obj\">]>");
    const std::string code = garmentCode(1, R"(, "include": "../secret/x.obj")");
    const std::string garment = given("t.obj", test::kPanel);
    const std::vector<std::string> marker{"marker", garment, "--unit", "mm", "--hide"};
    for (const auto& [name, text] :
         {std::pair("a.dxf", drawing), {"a.svg", picture}, {"a.specification.json", code}}) {
        const std::string path = given(name, text);
        EXPECT_EQ(expectConfined(path).status, 0) << name;
        expectConfined(path, {"compare", garment, "--unit", "mm", "--pattern"});
        expectConfined(path, {"prove", garment, "--unit", "mm", "--pattern"});
        if (text != code) {
            expectConfined(path, marker, {"--rounds", "1"});
        }
    }
    const std::string instance = given(
        "a.json", R"({"name": "../secret/x.obj", "include": "../secret/x.obj", "strip_height": 30,
"items": [{"id": 0, "demand": 1, "allowed_orientations": [0],
           "shape": {"type": "simple_polygon", "data": [[0, 0], [9, 0], [0, 9]]}}]})");
    EXPECT_EQ(expectConfined(instance, {"marker"}, {"--rounds", "1"}).status, 0);
    const std::string seams =
        given("s.json", R"({"version": 1, "include": "../secret/x.obj", "cuts": []})");
    EXPECT_EQ(expectConfined(seams, {"info", garment, "--unit", "mm", "--seams"}).status, 0);
    // These can be written, but not opened.
    EXPECT_EQ(traced({"info", given("a.pdf", "%PDF-1.4\n")}).status, 3);
    EXPECT_EQ(traced({"info", given("a.plt", "IN;SP1;\n")}).status, 3);
}

TEST_F(UntrustedFiles, PipesAndDevicesAreNotOpened) {
    TOILE_NEEDS_STRACE();
    const std::string pipe = (folder_ / "given/pipe").string();
    for (const char* ending : {".bin", ".obj"}) {
        ASSERT_EQ(mkfifo((pipe + ending).c_str(), 0600), 0);
    }
    fs::create_symlink("/dev/zero", folder_ / "given/device.bin");
    for (const char* name : {"pipe.bin", "device.bin"}) {
        const Opened opened = expectConfined(given("a.gltf", gltf(name)));
        EXPECT_EQ(opened.status, 3) << name;
        EXPECT_TRUE(opened.in("/dev/zero").empty());
    }
    const Opened batch =
        traced({"batch", given("list.txt", pipe + ".obj\n"), "-o", (folder_ / "out").string()});
    EXPECT_EQ(batch.status, 1) << batch.err;
    EXPECT_TRUE(batch.in("pipe.obj").empty());
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
    const std::string out = (folder_ / "out").string();
    const std::string panel = given("a.obj", test::kPanel);
    for (const char* command : {"info", "check", "walk", "compare", "prove"}) {
        expectWrites({command, panel, "--unit", "mm"}, {});
    }
    const std::string pattern = (folder_ / "given/a.dxf").string();
    EXPECT_EQ(test::toileRun({"flatten", panel, "--unit", "mm", "-o", pattern}).status, 0);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"flatten", "--report", out + "/r.json", "-o", out + "/a.svg"},
          {"compare", "--pattern", pattern, "-o", out + "/c.svg"},
          {"prove", "--report", out + "/p.json"},
          {"marker", "--rounds", "1", "-o", out + "/m.svg", "--report", out + "/m.json"}}) {
        std::vector<std::string> whole = command, files;
        whole.insert(whole.begin() + 1, {panel, "--unit", "mm"});
        std::ranges::copy_if(command, std::back_inserter(files),
                             [&out](const std::string& word) { return word.starts_with(out); });
        expectWrites(whole, files);
    }
}

TEST_F(UntrustedFiles, ProjectsAndListsNameFilesAnywhereToRead) {
    TOILE_NEEDS_STRACE();
    fs::create_directory(folder_ / "out");
    const std::string out = (folder_ / "out").string();
    const std::string secret = (folder_ / "secret").string();
    folder_.write("secret/a.obj", test::kPanel);
    folder_.write("secret/b.obj", test::kPanel);
    folder_.write("secret/r.dxf", dxf(dxfSquares(1, 300, 0)));
    folder_.write("secret/s.json", R"({"version": 1, "cuts": []})");
    Project project;
    project.files = {{secret + "/a.obj"}};
    project.reference = {{secret + "/r.dxf"}};
    project.loading.unit = LengthUnit::Millimetre;
    project.proof.body = secret + "/b.obj";
    project.proof.sewn = SewnPattern::Reference;
    const std::string path = (folder_ / "given/a.toile").string();
    ASSERT_TRUE(writeProject(path, project));
    EXPECT_FALSE(traced({"flatten", path, "-o", out + "/a.svg"}).in("/secret/a.obj").empty());
    const Opened proof = traced({"prove", path});
    EXPECT_FALSE(proof.in("/secret/r.dxf").empty()) << proof.err;
    EXPECT_FALSE(proof.in("/secret/b.obj").empty()) << proof.err;

    const std::string list = given("list.txt", secret + "/a.obj\t--seams\t" + secret + "/s.json\n");
    const Opened batch = traced({"batch", list, "-o", out + "/batch", "--unit", "mm"});
    EXPECT_EQ(batch.status, 0) << batch.err;
    EXPECT_FALSE(batch.in("/secret/a.obj").empty());
    EXPECT_FALSE(batch.in("/secret/s.json").empty());
    expectWrites({"batch", list, "-o", out + "/other", "--unit", "mm"}, {out + "/other"});
    // A line of a list cannot say where to write.
    for (const char* option : {"-o", "--report", "--ledger"}) {
        given("list.txt", secret + "/a.obj\t" + option + "\t" + out + "/b.svg\n");
        EXPECT_NE(test::toileRun({"batch", list, "-o", out + "/c"}).status, 0) << option;
        EXPECT_FALSE(fs::exists(folder_ / "out/b.svg"));
    }
}

TEST_F(UntrustedFiles, ServeReadsAndWritesWhatItIsAskedFor) {
    TOILE_NEEDS_STRACE();
    fs::create_directory(folder_ / "out");
    const std::string out = (folder_ / "out/a.svg").string();
    const auto serve = [this](const std::string& more) {
        const fs::path requests =
            folder_.write("requests", R"({"id": 1, "do": "load", "args": [")" +
                                          (folder_ / "secret/x.obj").string() +
                                          R"(", "--unit", "mm"]}
{"id": 2, "do": "flatten"}
)" + more);
        Opened opened = traced({"serve"}, {}, requests.string());
        EXPECT_EQ(opened.status, 0) << opened.err;
        EXPECT_FALSE(opened.in("/secret/x.obj").empty());
        std::erase_if(opened.written, [](const std::string& path) {
            return path.starts_with("/dev/") || path.starts_with("pipe:");
        });
        return opened.written;
    };
    EXPECT_EQ(serve(R"({"id": 3, "do": "prove"})"), std::vector<std::string>());
    const auto written = serve(R"({"id": 3, "do": "export", "args": ["-o", ")" + out + "\"]}\n");
    EXPECT_FALSE(written.empty());
    for (const std::string& path : written) {  // some file systems name a file after it is written
        EXPECT_TRUE(path.starts_with((folder_ / "out").string())) << path;
    }
}

TEST_F(UntrustedFiles, TheWindowOpensAFileAsCommandsDo) {
    TOILE_NEEDS_STRACE();
    fs::create_directory(folder_ / "home");
    const std::string home = (folder_ / "home").string();
    fs::permissions(home, fs::perms::owner_all);
    const std::vector<std::string> variables{"QT_QPA_PLATFORM=offscreen", "HOME=" + home,
                                             "XDG_RUNTIME_DIR=" + home};
    const std::string picture = (folder_ / "window.png").string();
    const auto open = [&](const std::string& path) {
        Opened opened = traced({path, "--screenshot", picture}, variables);
        EXPECT_FALSE(opened.in(fs::path(path).filename().string()).empty()) << opened.err;
        EXPECT_EQ(opened.in("/secret/"), std::vector<std::string>()) << path;
        for (const std::string& written : opened.written) {
            EXPECT_TRUE(written.starts_with(picture) || written.starts_with(home) ||
                        written.starts_with("/dev/") || written.starts_with("pipe:") ||
                        written.find("/memfd:") != std::string::npos)
                << written;
        }
    };
    open(given("a.obj", std::string("mtllib ../secret/x.mtl\n") + test::kPanel));
    if (!fs::exists(picture)) {
        GTEST_SKIP() << "needs a build with the window";
    }
    open(given("up.gltf", gltf("../secret/s.bin")));
    open(given("linked.gltf", gltf("linked/s.bin")));
    open(given("beside.gltf", gltf("s.bin")));
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
    EXPECT_LE(std::count(cost.err.begin(), cost.err.end(), '\n'), 50);
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

TEST_F(UntrustedFiles, AFileOfVeryManyGroupsIsRefused) {
    std::string obj = "v 0 0 0\nv 9 0 0\nv 0 9 0\n";
    for (int k = 0; k < 288'000; ++k) {
        char group[24];
        std::snprintf(group, sizeof group, "g %06x\nf 1 2 3\n", k);
        obj += group;
    }
    const std::string path = given("groups.obj", obj);
    expectCheap(path, true);
    const std::string err = costOf(path).err;
    EXPECT_NE(err.find("splitting by groups gives 288000 pieces"), std::string::npos) << err;
    EXPECT_NE(err.find("split it by something else"), std::string::npos) << err;
    const auto joined = test::toileRun({"info", path, "--split", "components", "--unit", "mm"});
    EXPECT_EQ(joined.status, 0) << joined.err;
}

TEST_F(UntrustedFiles, FilesOfTwoGibibytesAreRefused) {
    for (const char* name : {"a.obj", "a.stl", "a.gltf", "a.zip", "a.dxf", "a.toile"}) {
        const std::string path = given(name, "");
        fs::resize_file(path, (1ULL << 31) + 1);  // takes no room on the disk
        expectCheap(path, true);
        fs::remove(path);
    }
}

TEST_F(UntrustedFiles, DrawingsThatRepeatThemselvesAreCheap) {
    constexpr int kLevels = 4;
    constexpr std::size_t kTimes = 300;  // in each level: 8 thousand millions in all
    std::string blocks, uses, entities = "<!ENTITY a0 \"aaaaaaaaaa\">";
    for (int k = 0; k < kLevels; ++k) {
        const std::string next = std::to_string(k + 1), own = std::to_string(k);
        blocks += "0\nBLOCK\n2\nb" + own + "\n10\n0\n20\n0\n" +
                  times(kTimes, "0\nINSERT\n2\nb" + next + "\n10\n0\n20\n0\n") + "0\nENDBLK\n";
        uses +=
            "<g id=\"g" + own + "\">" + times(kTimes, "<use href=\"#g" + next + "\"/>") + "</g>";
        entities += "<!ENTITY a" + next + " \"" + times(kTimes, "&a" + own + ";") + "\">";
    }
    const std::string square =
        "0\nBLOCK\n2\nb4\n10\n0\n20\n0\n" + dxfSquares(1, 300, 0) + "0\nENDBLK\n";
    const std::string insert = "0\nINSERT\n2\nb";
    expectCheap(given("blocks.dxf", dxf(insert + "0\n10\n0\n20\n0\n", blocks + square)), false);
    // In rows and columns, each step less than a side.
    expectCheap(given("rows.dxf", dxf(insert + "4\n70\n30000\n71\n30000\n44\n9\n45\n9\n", square)),
                false);
    // Each square in the next one: all but one could be the border of a sheet.
    std::string nested;
    for (int k = 0; k < 20'000; ++k) {
        nested += dxfSquares(1, 100 + k, 0);
    }
    expectCheap(given("nested.dxf", dxf(nested)), false);
    expectCheap(given("use.svg", svg(uses + R"(<path id="g4" d="M0 0H50V50Z"/>)")), false);
    expectCheap(
        given("entities.svg", svg("<text>&a4;</text>", "<!DOCTYPE svg [" + entities + "]>")),
        false);
}

class UntrustedFilesSlow : public UntrustedFiles {};

/// A binary STL file of triangles of 100 to 200 mm in a cube of a metre: each crosses hundreds.
std::string crossingTriangles(std::uint32_t count) {
    std::string bytes(80, ' ');
    const auto add = [&bytes](const auto& value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    add(count);
    test::Generator random(7);
    for (std::uint32_t k = 0; k < count; ++k) {
        const double centre[] = {random.between(0, 1000), random.between(0, 1000),
                                 random.between(0, 1000)};
        bytes.append(3 * sizeof(float), '\0');  // normal
        for (int corner = 0; corner < 3; ++corner) {
            for (const double x : centre) {
                add(static_cast<float>(x + random.between(-100, 100)));
            }
        }
        add(std::uint16_t{0});
    }
    return bytes;
}

TEST_F(UntrustedFilesSlow, LargeFilesOfEveryKindAreCheap) {
    constexpr std::size_t kBytes = 4'900'000;
    const auto filled = [](const std::string& text) { return times(kBytes / text.size(), text); };
    const std::string count = std::to_string(kBytes / 8);
    const std::string plyFaces =
        "property float x\nproperty float y\nproperty float z\nelement face " + count +
        "\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n9 0 0\n0 9 0\n";
    std::string apart, squares, blocks;
    for (int k = 0; k < 50'000; ++k) {
        blocks += "0\nBLOCK\n8\n1\n2\nb" + std::to_string(k) +
                  "\n10\n0\n20\n0\n0\nINSERT\n2\nsquare\n70\n500\n71\n500\n0\nENDBLK\n";
    }
    blocks += "0\nBLOCK\n2\nsquare\n10\n0\n20\n0\n" + dxfSquares(1, 300, 0) + "0\nENDBLK\n";
    for (int k = 0; k < 90'000; ++k) {
        char facet[256];
        std::snprintf(facet, sizeof facet, "v %d %d 0\nv %d.5 %d 0\nv %d %d.5 0\nf -3 -2 -1\n",
                      k % 300, k / 300, k % 300, k / 300, k % 300, k / 300);
        apart += facet;
        squares += "<path d=\"M-" + std::to_string(k) + " 0h5v5h-5z\"/>";
    }
    for (const auto& [name, text] :
         {std::pair("apart.obj", apart),
          {"faces.ply",
           "ply\nformat ascii 1.0\nelement vertex 3\n" + plyFaces + filled("3 0 1 2\n")},
          {"lies.ply", "ply\nformat ascii 1.0\nelement vertex 2000000000\n" + plyFaces},
          {"faces.off", "OFF\n3 " + count + " 0\n0 0 0\n9 0 0\n0 9 0\n" + filled("3 0 1 2\n")},
          {"lies.off", "OFF\n2000000000 2000000000 0\n" + filled("0 0 0\n")},
          {"a.stl", "solid a\n" + filled("facet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                         "vertex 9 0 0\nvertex 0 9 0\nendloop\nendfacet\n")},
          {"deep.usda", "#usda 1.0\n" + filled("def Xform \"a\" {\n")},
          {"squares.dxf", dxf(dxfSquares(50'000, 15, 20))},
          {"blocks.dxf", dxf("", blocks)},
          {"inserts.dxf",
           dxf(filled("0\nINSERT\n2\nsquare\n"), blocks.substr(blocks.rfind("0\nBLOCK")))},
          {"circles.dxf", dxf(filled("0\nCIRCLE\n8\n1\n10\n0\n20\n0\n40\n1e7\n"))},
          {"holes.dxf",
           dxf(dxfSquares(1, 9999, 0) + filled("0\nCIRCLE\n8\n1\n10\n9\n20\n9\n40\n1\n"))},
          {"crossing.stl", crossingTriangles(98'000)},
          {"squares.svg", svg(squares)},
          {"deep.svg", svg(times(kBytes / 8, "<g>") + times(kBytes / 8, "</g>"))},
          {"panels.specification.json", garmentCode(20'000)},
          {"deep.specification.json", times(kBytes, "[")}}) {
        const std::string path = given(name, text);
        expectCheap(path, false);
        fs::remove(path);
    }
}

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
