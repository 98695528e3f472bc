// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/shared_data.h"

namespace toile::test {

namespace {

// No objects: tests ask for files before main.
constexpr const char* kShared = TOILE_SHARED_DATA;
constexpr const char* kTree = TOILE_SOURCE_DIR;

}  // namespace

std::filesystem::path sharedFile(const std::string& name) {
    return std::filesystem::path(kShared) / name;
}

std::filesystem::path sourceFile(const std::string& name) {
    return std::filesystem::path(kTree) / name;
}

std::filesystem::path dataFile(const std::string& name) {
    return name.starts_with("samples/") ? sourceFile("resources/" + name) : sharedFile(name);
}

bool mayBeMissing(const std::filesystem::path& path) {
    return path.string().starts_with(kShared) && !std::filesystem::exists(kShared);
}

}  // namespace toile::test
