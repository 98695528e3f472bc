// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"

#include <atomic>
#include <fstream>
#include <random>
#include <system_error>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#else
#include <fcntl.h>
#include <unistd.h>
#endif

namespace toile {
namespace fs = std::filesystem;

namespace {

/// A name beside the target that no other writer uses at the same time, in this process or another.
fs::path temporaryBeside(const fs::path& path) {
    static std::atomic<unsigned> counter{std::random_device{}()};
    fs::path beside = path;
    beside += ".part" + std::to_string(counter.fetch_add(1));
    return beside;
}

Result<void> writeInPlace(const fs::path& path, std::string_view bytes) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (!file) {
        return Error{ErrorCode::FileUnwritable, path.string(), "it cannot be created"};
    }
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();  // flushes; a full disk shows here at the latest
    if (!file) {
        return Error{ErrorCode::FileUnwritable, path.string(), "writing stopped half-way"};
    }
    return {};
}

/// Waits until the disk has the bytes: a rename may reach it before them otherwise, and a power cut
/// would leave an empty file in the old one's place. Where the system cannot, nothing is lost but
/// that.
void flushToDisk(const fs::path& path) {
#ifdef _WIN32
    const int file = ::_wopen(path.c_str(), _O_RDWR | _O_BINARY);
    if (file >= 0) {
        (void)::_commit(file);
        (void)::_close(file);
    }
#else
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file >= 0) {
        (void)::fsync(file);
        (void)::close(file);
    }
#endif
}

}  // namespace

Result<std::string> readFile(const fs::path& path) {
    std::error_code failed;
    const auto status = fs::status(path, failed);
    if (!fs::exists(status)) {
        const bool missing = status.type() == fs::file_type::not_found;
        return Error{ErrorCode::FileUnreadable, path.string(),
                     missing ? "there is no such file" : failed.message()};
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

Result<void> writeFile(const fs::path& wanted, std::string_view bytes) {
    std::error_code failed;
    // Through a link to what it names, so that the link stays one.
    const fs::path path = fs::is_symlink(wanted, failed) ? fs::canonical(wanted, failed) : wanted;
    const fs::file_status before = fs::status(path, failed);
    if (fs::exists(before) && !fs::is_regular_file(before)) {
        // A folder is an error; a pipe or terminal cannot be replaced, only written to.
        return fs::is_directory(before)
                   ? Error{ErrorCode::FileUnwritable, wanted.string(), "it is a folder"}
                   : writeInPlace(path, bytes);
    }
    const fs::path part = temporaryBeside(path);
    Result<void> written = writeInPlace(part, bytes);
    if (!written) {
        fs::remove(part, failed);
        return Error{ErrorCode::FileUnwritable, wanted.string(), written.error().detail};
    }
    flushToDisk(part);
    if (fs::exists(before)) {
        fs::permissions(part, before.permissions(), failed);
    }
    std::error_code ignored;
    fs::rename(part, path, failed);
    if (failed) {
        fs::remove(part, ignored);
        return Error{ErrorCode::FileUnwritable, wanted.string(), failed.message()};
    }
    return {};
}

}  // namespace toile
