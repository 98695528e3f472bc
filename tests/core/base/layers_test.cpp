// SPDX-License-Identifier: GPL-3.0-or-later
// Watches the layers: the core knows neither Qt nor OpenGL, and a folder includes only what lies
// above it in the module maps of docs/architecture.md.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

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
    {"sheet", {"base", "mesh", "quality", "pattern"}},
    {"export",
     {"base", "mesh", "io", "cut", "garment", "quality", "flatten", "seam", "compare", "pattern",
      "sheet"}},
    {"pipeline",
     {"base", "mesh", "io", "cut", "garment", "quality", "flatten", "seam", "compare", "pattern",
      "sheet", "export"}},
    {"project",
     {"base", "mesh", "io", "cut", "garment", "quality", "flatten", "seam", "pattern", "sheet",
      "pipeline"}},
    {"check",
     {"base", "mesh", "garment", "quality", "flatten", "seam", "sheet", "export", "project"}},
};

/// A line of the app's table.
struct AppFolder {
    std::string name;  ///< below app/
    Folders mayUse;
};

/// As docs/architecture.md has it, from above downwards.
std::vector<AppFolder> appFolders() {
    const std::regex row("^\\| `([a-z/]+)` \\|.*\\| ([a-z/, –]+) \\|$");
    std::ifstream page(kRoot / "docs" / "architecture.md");
    std::vector<AppFolder> folders;
    bool isInTable = false;
    std::smatch match;
    for (std::string line; std::getline(page, line);) {
        isInTable = (isInTable && line.starts_with('|')) || line == "| Folder | Holds | May use |";
        if (!isInTable || !std::regex_match(line, match, row)) {
            continue;
        }
        AppFolder folder{match[1], {}};
        std::istringstream names(match[2].str());
        for (std::string name; std::getline(names >> std::ws, name, ',');) {
            if (name != "–") {
                folder.mayUse.insert(name);
            }
        }
        folders.push_back(std::move(folder));
    }
    return folders;
}

/// The deepest folder of the table that a file below app/ lies in; empty of app/ itself.
std::string appFolderOf(const std::vector<AppFolder>& folders, const std::string& file) {
    std::string deepest;
    for (const AppFolder& folder : folders) {
        if (file.starts_with(folder.name + '/') && folder.name.size() > deepest.size()) {
            deepest = folder.name;
        }
    }
    return deepest;
}

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

TEST(Layers, TheTableOfTheAppGoesDownwards) {
    const std::vector<AppFolder> folders = appFolders();
    Folders above;
    for (const AppFolder& folder : folders) {
        for (const std::string& used : folder.mayUse) {
            EXPECT_TRUE(above.contains(used)) << "app/" << folder.name << " may use " << used;
        }
        EXPECT_TRUE(above.insert(folder.name).second) << folder.name << " has two lines";
    }
    for (const auto& entry : fs::directory_iterator(kRoot / "app")) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(!entry.is_directory() || above.contains(name))
            << "app/" << name << " is not in docs/architecture.md";
    }
    for (const std::string& name : above) {
        EXPECT_TRUE(fs::is_directory(kRoot / "app" / name)) << name;
    }
}

TEST(Layers, AppFoldersIncludeOnlyWhatTheirLineNames) {
    const std::vector<AppFolder> folders = appFolders();
    std::map<std::string, Folders> mayUse;
    for (const AppFolder& folder : folders) {
        mayUse[folder.name] = folder.mayUse;
    }
    int seen = 0;
    forEachInclude(kRoot / "app", [&](const fs::path& file, const std::string& included) {
        const std::string own = appFolderOf(folders, fs::relative(file, kRoot / "app").string());
        if (own.empty() || !included.starts_with("app/")) {
            return;
        }
        ++seen;
        const std::string used = appFolderOf(folders, included.substr(4));
        const bool isOwn =
            !used.empty() && used.substr(0, used.find('/')) == own.substr(0, own.find('/'));
        EXPECT_TRUE(isOwn || mayUse.at(own).contains(used)) << file << " includes " << included;
    });
    EXPECT_GT(seen, 100);
}

/// The types of its matrices stay in app/render too: what a camera says to others it says in Eigen.
TEST(Layers, OnlyRenderTurnsMatricesIntoGlm) {
    forEachInclude(kRoot / "app", [](const fs::path& file, const std::string& included) {
        EXPECT_TRUE(file.parent_path().filename() == "render" ||
                    included != "app/render/glm_eigen.h")
            << file;
    });
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
        "^(E?GL/|qopengl|glm/|QOpenGL(Functions|ExtraFunctions|Shader|Buffer|VertexArray|Texture|"
        "Framebuffer|Version))");
    forEachInclude(kRoot / "app", [&](const fs::path& file, const std::string& included) {
        const bool inRender = file.parent_path().filename() == "render";
        EXPECT_TRUE(inRender || !std::regex_search(included, gl))
            << file << " includes " << included;
    });
}

}  // namespace
