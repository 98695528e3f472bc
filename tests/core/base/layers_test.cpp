// SPDX-License-Identifier: GPL-3.0-or-later
// Watches the layers: the core knows neither Qt nor OpenGL, and a folder includes only what lies
// above it in the tables of docs/architecture.md.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/support/shared_data.h"

namespace {

namespace fs = std::filesystem;
using Folders = std::set<std::string>;

const fs::path kRoot = toile::test::sourceFile("");

/// A line of a table, for each folder that it names.
struct Folder {
    std::string name;  ///< below core/ or app/
    Folders mayUse;
};

const char* const kCoreTable = "| Core folder | Holds | May use |";
const char* const kAppTable = "| Folder | Holds | May use |";

/// The words of a cell between commas and "and".
std::vector<std::string> wordsOf(const std::string& cell) {
    const std::regex separator(",| and ");
    std::vector<std::string> words;
    for (std::sregex_token_iterator it(cell.begin(), cell.end(), separator, -1), end; it != end;
         ++it) {
        const std::string word = std::regex_replace(it->str(), std::regex("^[ `]+|[ `]+$"), "");
        if (!word.empty() && word != "–") {
            words.push_back(word);
        }
    }
    return words;
}

/// "all above", "all above but this and that", or the folders by name.
Folders used(const std::string& cell, const std::vector<Folder>& above) {
    const std::string all = "all above";
    const std::vector<std::string> words =
        wordsOf(std::regex_replace(cell, std::regex("^ *" + all + "( but)?"), ""));
    if (cell.find(all) == std::string::npos) {
        return {words.begin(), words.end()};
    }
    Folders folders;
    for (const Folder& folder : above) {
        folders.insert(folder.name);
    }
    for (const std::string& word : words) {
        EXPECT_EQ(folders.erase(word), 1U) << word << " is not above";
    }
    return folders;
}

/// A table of docs/architecture.md, from its heading downwards.
std::vector<Folder> foldersOf(const std::string& heading) {
    std::ifstream page(kRoot / "docs" / "architecture.md");
    std::vector<Folder> folders;
    std::string line;
    while (std::getline(page, line) && line != heading) {
    }
    std::getline(page, line);  // the rule below the heading
    while (std::getline(page, line) && line.starts_with("| ")) {
        const std::size_t first = line.find('|', 1), last = line.rfind('|', line.size() - 2);
        const Folders mayUse = used(line.substr(last + 1, line.size() - last - 2), folders);
        for (const std::string& name : wordsOf(line.substr(1, first - 1))) {
            folders.push_back({name, mayUse});
        }
    }
    return folders;
}

std::map<std::string, Folders> mayUseOf(const std::vector<Folder>& folders) {
    std::map<std::string, Folders> mayUse;
    for (const Folder& folder : folders) {
        mayUse[folder.name] = folder.mayUse;
    }
    return mayUse;
}

/// A folder uses those above it only, has one line, and is there; no folder is without a line.
void expectWholeAndDownwards(const std::vector<Folder>& folders, const std::string& root) {
    Folders above;
    for (const Folder& folder : folders) {
        for (const std::string& name : folder.mayUse) {
            EXPECT_TRUE(above.contains(name)) << root << '/' << folder.name << " may use " << name;
        }
        EXPECT_TRUE(above.insert(folder.name).second) << folder.name << " has two lines";
        EXPECT_TRUE(fs::is_directory(kRoot / root / folder.name)) << folder.name;
    }
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / root)) {
        const std::string name = fs::relative(entry.path(), kRoot / root).generic_string();
        const std::string parent = name.substr(0, name.find_last_of('/'));
        // Below the top only where the parent's rooms have lines.
        const bool hasLine =
            parent == name || std::ranges::any_of(above, [&](const std::string& other) {
                return other.starts_with(parent + '/');
            });
        EXPECT_TRUE(!entry.is_directory() || !hasLine || name == "cmake" || above.contains(name))
            << root << '/' << name << " is not in docs/architecture.md";
    }
}

/// The deepest folder of the table that a file below core/ or app/ lies in; empty of these
/// themselves.
std::string folderOf(const std::vector<Folder>& folders, const std::string& file) {
    std::string deepest;
    for (const Folder& folder : folders) {
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

TEST(Layers, TheTablesGoDownwardsAndNameEveryFolder) {
    expectWholeAndDownwards(foldersOf(kCoreTable), "core");
    expectWholeAndDownwards(foldersOf(kAppTable), "app");
}

TEST(Layers, CoreFoldersIncludeOnlyWhatTheirLineNames) {
    const std::vector<Folder> folders = foldersOf(kCoreTable);
    const std::map<std::string, Folders> mayUse = mayUseOf(folders);
    int seen = 0;
    forEachInclude(kRoot / "core", [&](const fs::path& file, const std::string& included) {
        if (included.starts_with("core/")) {
            const std::string own =
                folderOf(folders, fs::relative(file, kRoot / "core").generic_string());
            const std::string other = folderOf(folders, included.substr(5));
            EXPECT_TRUE(other == own || mayUse.at(own).contains(other))
                << file << " includes " << included;
            ++seen;
        }
    });
    EXPECT_GT(seen, 100);
}

TEST(Layers, AppFoldersIncludeOnlyWhatTheirLineNames) {
    const std::vector<Folder> folders = foldersOf(kAppTable);
    const std::map<std::string, Folders> mayUse = mayUseOf(folders);
    int seen = 0;
    forEachInclude(kRoot / "app", [&](const fs::path& file, const std::string& included) {
        const std::string own = folderOf(folders, fs::relative(file, kRoot / "app").string());
        if (own.empty() || !included.starts_with("app/")) {
            return;
        }
        ++seen;
        const std::string other = folderOf(folders, included.substr(4));
        EXPECT_TRUE(other == own || mayUse.at(own).contains(other))
            << file << " includes " << included;
    });
    EXPECT_GT(seen, 100);
}

/// The types of its matrices stay in app/render too: what a camera says to others it says in Eigen.
TEST(Layers, OnlyRenderTurnsMatricesIntoGlm) {
    int seen = 0;
    forEachInclude(kRoot / "app", [&seen](const fs::path& file, const std::string& included) {
        const bool isThere = included == "app/render/glm_eigen.h";
        seen += isThere ? 1 : 0;
        EXPECT_TRUE(!isThere || file.parent_path().filename() == "render") << file;
    });
    EXPECT_GT(seen, 0);
}

TEST(Layers, TheCommandLineIsFreeOfQt) {
    int seen = 0;
    forEachInclude(kRoot / "app" / "cli",
                   [&seen](const fs::path& file, const std::string& included) {
                       ++seen;
                       EXPECT_FALSE(included.starts_with("Q")) << file << " includes " << included;
                   });
    EXPECT_GT(seen, 20);
}

/// A view is a QOpenGLWidget and may know its context; drawing calls, buffers and shaders may not
/// leave app/render.
TEST(Layers, OnlyRenderDrawsWithOpenGL) {
    const std::regex gl(
        "^(E?GL/|epoxy/|qopengl|glm/"
        "|QOpenGL(Functions|ExtraFunctions|Shader|Buffer|VertexArray|Texture|"
        "Framebuffer|Version))");
    int seen = 0;
    forEachInclude(kRoot / "app", [&](const fs::path& file, const std::string& included) {
        const bool draws = std::regex_search(included, gl);
        seen += draws ? 1 : 0;
        EXPECT_TRUE(!draws || file.parent_path().filename() == "render")
            << file << " includes " << included;
    });
    EXPECT_GT(seen, 0);
}

}  // namespace
