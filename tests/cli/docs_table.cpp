// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/docs_table.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace toile::test {

void expectTableInDocs(const std::string& page, const std::string& name, const std::string& table) {
    const auto path = std::filesystem::path(TOILE_SOURCE_DIR) / "docs" / page;
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string opening = "<!-- table: " + name + ", written by a test -->\n";
    const auto begin = text.find(opening);
    const auto end = text.find("<!-- end of table -->\n", begin);
    ASSERT_TRUE(begin != std::string::npos && end != std::string::npos) << path << " has no place";
    const auto start = begin + opening.size();
    if (std::getenv("TOILE_UPDATE_DOCS") != nullptr) {
        std::ofstream(path, std::ios::binary) << text.substr(0, start) << table << text.substr(end);
        return;
    }
    EXPECT_EQ(text.substr(start, end - start), table) << "write it anew: TOILE_UPDATE_DOCS=1";
}

}  // namespace toile::test
