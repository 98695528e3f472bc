// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/file.h"

#include <cerrno>
#include <fstream>
#include <limits>
#include <new>
#include <optional>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "core/base/id.h"

namespace toile {
namespace fs = std::filesystem;

namespace {

// 2 GiB: no reader counts further.
constexpr std::uintmax_t kMaxBytes = std::numeric_limits<int>::max();
constexpr int kMaxLinks = 40;  // the system's own limit

Error unreadable(const fs::path& path, std::string why) {
    return {ErrorCode::FileUnreadable, Subject::file(path.string()), std::move(why)};
}

Error unwritable(const fs::path& path, std::string why) {
    return {ErrorCode::FileUnwritable, Subject::file(path.string()), std::move(why)};
}

/// Resolves links; the target need not exist.
fs::path throughLinks(fs::path path) {
    std::error_code failed;
    for (int k = 0; k < kMaxLinks && fs::is_symlink(path, failed); ++k) {
        path = path.parent_path() / fs::read_symlink(path, failed);
    }
    return path;
}

/// Prefix of the names of temporary files: short, since a file's name may have the maximum length.
std::string partPrefix(const fs::path& path) {
    return ".toile-" + std::to_string(contentHash(path.filename().string())) + "-";
}

/// A name that no other writer uses at the same time.
fs::path temporaryBeside(const fs::path& path) {
    std::random_device random;
    return path.parent_path() / (partPrefix(path) + std::to_string(random()));
}

Result<void> writeInPlace(const fs::path& path, std::string_view bytes) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    if (!file) {
        return unwritable(path, "it cannot be created");
    }
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();  // flushes; a full disk is reported here at the latest
    if (!file) {
        return unwritable(path, "writing stopped half-way");
    }
    return {};
}

std::error_code lastFault() {
    return {errno, std::generic_category()};
}

class Descriptor {
public:
    Descriptor(const fs::path& path, int flags) : fd_(::open(path.c_str(), flags, 0666)) {}
    ~Descriptor() {
        if (fd_ >= 0) {
            ::close(fd_);
        }
    }
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor& operator=(Descriptor&&) = delete;

    explicit operator bool() const { return fd_ >= 0; }
    int number() const { return fd_; }

    std::error_code write(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
            if (written < 0 && errno != EINTR) {
                return lastFault();
            }
            bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
        }
        return {};
    }

    /// Waits until the data is on the disk, if the file system supports that: the rename might
    /// reach the disk before the bytes, and a power cut would leave an empty file.
    std::error_code flush() const {
        return ::fsync(fd_) == 0 || errno == EINVAL || errno == ENOTSUP ? std::error_code()
                                                                        : lastFault();
    }

private:
    int fd_;
};

/// Copies owner, permissions and access list from `old`.
std::error_code makeLike(const Descriptor& file, const fs::path& old) {
    struct stat was, is;
    if (::stat(old.c_str(), &was) != 0) {
        return {};  // no old file
    }
    const bool theirs =
        ::fstat(file.number(), &is) == 0 && (is.st_uid != was.st_uid || is.st_gid != was.st_gid);
    if ((theirs && ::fchown(file.number(), was.st_uid, was.st_gid) != 0) ||
        ::fchmod(file.number(), was.st_mode & 07777U) != 0) {
        return lastFault();
    }
    constexpr auto kAccessList = "system.posix_acl_access";
    if (const ssize_t size = ::getxattr(old.c_str(), kAccessList, nullptr, 0); size > 0) {
        std::string list(static_cast<std::size_t>(size), '\0');
        if (::getxattr(old.c_str(), kAccessList, list.data(), list.size()) != size ||
            ::fsetxattr(file.number(), kAccessList, list.data(), list.size(), 0) != 0) {
            return lastFault();
        }
    } else {
        ::fremovexattr(file.number(), kAccessList);  // the folder may give new files one
    }
    return {};
}

std::error_code fill(const Descriptor& file, std::string_view bytes, const fs::path& old) {
    std::error_code failed = makeLike(file, old);
    if (!failed) {
        failed = file.write(bytes);
    }
    return failed ? failed : file.flush();
}

/// Each writer locks its temporary file from before it has a name until it is renamed: an unlocked
/// temporary file was left by a killed process. If a file system has no locks, no file counts as
/// left behind.
bool tryHold(const Descriptor& part) {
    return ::flock(part.number(), LOCK_EX | LOCK_NB) == 0;
}

/// Deletes temporary files of the same target that killed writers left.
void clearPartsOf(const fs::path& path) {
    const std::string prefix = partPrefix(path);
    std::error_code failed;
    const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        if (entry->path().filename().string().starts_with(prefix)) {
            const Descriptor part(entry->path(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
            if (part && tryHold(part)) {
                ::unlink(entry->path().c_str());
            }
        }
    }
}

/// Writes the bytes to a locked file called `part`. If the system supports it, the file has no name
/// until it is complete, so that hardly anything is left if the program ends.
std::error_code makePart(const fs::path& part, std::string_view bytes, const fs::path& old,
                         std::optional<Descriptor>& made) {
    const fs::path folder = part.parent_path().empty() ? fs::path(".") : part.parent_path();
    if (made.emplace(folder, O_TMPFILE | O_WRONLY | O_CLOEXEC); *made) {
        tryHold(*made);
        if (const std::error_code failed = fill(*made, bytes, old)) {
            return failed;
        }
        const std::string self = "/proc/self/fd/" + std::to_string(made->number());
        if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, part.c_str(), AT_SYMLINK_FOLLOW) == 0) {
            return {};
        }
    }
    if (made.emplace(part, O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC); !*made) {
        return lastFault();
    }
    tryHold(*made);
    return fill(*made, bytes, old);
}

std::error_code replace(const fs::path& path, std::string_view bytes) {
    clearPartsOf(path);
    const fs::path part = temporaryBeside(path);
    std::optional<Descriptor> held;
    std::error_code failed = makePart(part, bytes, path, held);
    if (!failed && ::rename(part.c_str(), path.c_str()) != 0) {
        failed = lastFault();
    }
    if (failed) {
        ::unlink(part.c_str());
        return failed;
    }
    const fs::path folder = path.parent_path().empty() ? fs::path(".") : path.parent_path();
    const Descriptor names(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    return names ? names.flush() : std::error_code();  // some folders can be written but not read
}

/// True if permissions of the folder or the old file forbid replacing it.
bool mayNotReplace(const std::error_code& failed) {
    return failed == std::errc::permission_denied || failed == std::errc::operation_not_permitted ||
           failed == std::errc::read_only_file_system;
}

}  // namespace

std::string pathText(const fs::path& path) {
    const std::u8string text = path.generic_u8string();
    return {text.begin(), text.end()};
}

Result<std::string> readFile(const fs::path& path) {
    std::error_code failed;
    const auto status = fs::status(path, failed);
    if (!fs::exists(status)) {
        const bool missing = status.type() == fs::file_type::not_found;
        return unreadable(path, missing ? "there is no such file" : failed.message());
    }
    if (fs::is_directory(status)) {
        return unreadable(path, "it is a folder");
    }
    if (!fs::is_regular_file(status)) {  // reading a pipe may wait forever, and works only once
        return unreadable(path, "it is a pipe or a device; save it as a file first");
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return unreadable(path, "it cannot be opened");
    }
    const auto size = fs::file_size(path, failed);
    const Error tooLong = unreadable(path, "it is longer than 2 GiB");
    if (!failed && size > kMaxBytes) {
        return tooLong;
    }
    std::string bytes;
    try {
        if (!failed) {  // one read; the loop below is for a file that grows, or has no stated size
            bytes.resize(size);
            file.read(bytes.data(), static_cast<std::streamsize>(size));
            bytes.resize(static_cast<std::size_t>(file.gcount()));
            file.clear(file.rdstate() & ~std::ios::failbit);
        }
        char block[1 << 16];
        while (file.read(block, sizeof block) || file.gcount() > 0) {
            bytes.append(block, static_cast<std::size_t>(file.gcount()));
            if (bytes.size() > kMaxBytes) {
                return tooLong;
            }
        }
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::OutOfMemory, Subject::file(path.string())};
    }
    if (file.bad()) {
        return unreadable(path, "reading stopped half-way");
    }
    return bytes;
}

Result<void> writeFile(const fs::path& wanted, std::string_view bytes) {
    const fs::path path = throughLinks(wanted);
    std::error_code failed;
    if (fs::is_symlink(path, failed)) {
        return unwritable(wanted, "its link points to nothing");
    }
    const fs::file_status before = fs::status(path, failed);
    if (fs::is_directory(before)) {
        return unwritable(wanted, "it is a folder");
    }
    bool inPlace = fs::exists(before) && !fs::is_regular_file(before);
    if (!inPlace) {
        failed = replace(path, bytes);
        if (!failed) {
            return {};
        }
        inPlace = fs::exists(before) && mayNotReplace(failed);
    }
    const auto written = inPlace ? writeInPlace(path, bytes) : unwritable(wanted, failed.message());
    return written ? written : unwritable(wanted, written.error().detail);
}

}  // namespace toile
