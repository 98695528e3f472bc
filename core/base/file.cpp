// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"

#include <atomic>
#include <fstream>
#include <system_error>

namespace toile {
namespace fs = std::filesystem;

namespace {

/// A name beside the target that no other writer of this process uses at the same time.
fs::path temporaryBeside(const fs::path& path) {
    static std::atomic<unsigned> counter{0};
    fs::path beside = path;
    beside += ".part" + std::to_string(counter.fetch_add(1));
    return beside;
}

}  // namespace

Result<std::string> readFile(const fs::path& path) {
    std::error_code failed;
    const auto status = fs::status(path, failed);
    if (failed || !fs::exists(status)) {
        return Error{ErrorCode::FileUnreadable, path.string(), "there is no such file"};
    }
    if (fs::is_directory(status)) {
        return Error{ErrorCode::FileUnreadable, path.string(), "it is a folder"};
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return Error{ErrorCode::FileUnreadable, path.string(), "it cannot be opened"};
    }
    std::string bytes;
    const auto size = fs::file_size(path, failed);
    if (!failed) {  // one read for a regular file, the tail loop below for anything else
        bytes.resize(size);
        file.read(bytes.data(), static_cast<std::streamsize>(size));
        bytes.resize(static_cast<std::size_t>(file.gcount()));
        file.clear(file.rdstate() & ~std::ios::failbit);
    }
    char block[1 << 16];
    while (file.read(block, sizeof block) || file.gcount() > 0) {
        bytes.append(block, static_cast<std::size_t>(file.gcount()));
    }
    if (file.bad()) {
        return Error{ErrorCode::FileUnreadable, path.string(), "reading stopped half-way"};
    }
    return bytes;
}

Result<void> writeFile(const fs::path& path, std::string_view bytes) {
    const fs::path part = temporaryBeside(path);
    std::error_code ignored;
    {
        std::ofstream file(part, std::ios::binary | std::ios::trunc);
        if (!file) {
            return Error{ErrorCode::FileUnwritable, path.string(), "it cannot be created"};
        }
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        file.flush();
        if (!file) {
            file.close();
            fs::remove(part, ignored);
            return Error{ErrorCode::FileUnwritable, path.string(), "writing stopped half-way"};
        }
    }
    std::error_code failed;
    fs::rename(part, path, failed);
    if (failed) {
        fs::remove(part, ignored);
        return Error{ErrorCode::FileUnwritable, path.string(), failed.message()};
    }
    return {};
}

}  // namespace toile
