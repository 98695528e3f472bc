// SPDX-License-Identifier: GPL-3.0-or-later
// Watches the layers: the core knows neither Qt nor OpenGL, and a core folder includes only what
// lies above it in the module map of docs/architecture.md.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using Folders = std::set<std::string>;

const fs::path kRoot = TOILE_SOURCE_DIR;

const std::map<std::string, Folders> kMayUse = {
    {"base", {}},
    {"mesh", {"base"}},
    {"linalg", {"base"}},
    {"cut", {"base", "mesh"}},
    {"io", {"base", "mesh"}},
    {"garment", {"base", "mesh", "io", "cut"}},
    {"quality", {"base", "mesh", "garment"}},
    {"flatten", {"base", "mesh", "linalg", "garment", "quality"}},
    {"seam", {"base", "mesh", "garment", "quality", "flatten"}},
    {"compare", {"base", "mesh", "garment", "quality", "flatten", "seam"}},
    {"pattern", {"base", "mesh", "garment", "quality", "flatten", "seam"}},
    {"sheet", {"base", "mesh", "pattern"}},
    {"export",
     {"base", "mesh", "io", "cut", "garment", "quality", "flatten", "seam", "compare", "pattern",
      "sheet"}},
    {"pipeline",
     {"base", "mesh", "io", "cut", "garment", "quality", "flatten", "seam", "compare", "pattern",
      "sheet", "export"}},
};

template <class Visit>
void forEachInclude(const fs::path& folder, const Visit& visit) {
    const std::regex include("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const auto ending = entry.path().extension();
        if (ending != ".h" && ending != ".cpp") {
            continue;
        }
        std::ifstream file(entry.path());
        std::smatch match;
        for (std::string line; std::getline(file, line);) {
            if (std::regex_search(line, match, include)) {
                visit(entry.path(), match[1].str());
            }
        }
    }
}

TEST(Layers, TheCoreKnowsNeitherQtNorOpenGL) {
    const std::regex forbidden("^(Q[A-Z]|Qt|GL/|GLES|glm/|EGL/|app/)");
    int seen = 0;
    forEachInclude(kRoot / "core", [&](const fs::path& file, const std::string& included) {
        ++seen;
        EXPECT_FALSE(std::regex_search(included, forbidden)) << file << " includes " << included;
    });
    EXPECT_GT(seen, 100);
}

TEST(Layers, CoreFoldersIncludeOnlyUpwards) {
    for (const auto& entry : fs::directory_iterator(kRoot / "core")) {
        const std::string folder = entry.path().filename().string();
        if (!entry.is_directory() || folder == "cmake") {
            continue;
        }
        ASSERT_TRUE(kMayUse.contains(folder)) << "core/" << folder << " is not in the map";
        forEachInclude(entry.path(), [&](const fs::path& file, const std::string& included) {
            if (included.starts_with("core/")) {
                const std::string used = included.substr(5, included.find('/', 5) - 5);
                EXPECT_TRUE(used == folder || kMayUse.at(folder).contains(used))
                    << file << " includes " << included;
            }
        });
    }
}

TEST(Layers, TheCommandLineIsFreeOfQt) {
    forEachInclude(kRoot / "app" / "cli", [](const fs::path& file, const std::string& included) {
        EXPECT_FALSE(included.starts_with("Q")) << file << " includes " << included;
    });
}

/// A view is a QOpenGLWidget and may know its context; drawing calls, buffers and shaders may not
/// leave app/render.
TEST(Layers, OnlyRenderDrawsWithOpenGL) {
    const std::regex gl(
        "^(GL/|glm/|QOpenGL(Functions|ExtraFunctions|Shader|Buffer|VertexArray|Texture|Framebuffer|"
        "Version))");
    forEachInclude(kRoot / "app", [&](const fs::path& file, const std::string& included) {
        const bool inRender = file.parent_path().filename() == "render";
        EXPECT_TRUE(inRender || !std::regex_search(included, gl))
            << file << " includes " << included;
    });
}

}  // namespace
