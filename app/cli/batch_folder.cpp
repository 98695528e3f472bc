// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch_folder.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/cli/batch_record.h"
#include "core/base/file.h"

namespace toile::app {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kBetweenLooks{100};

Error cannotWrite(const fs::path& folder, const std::error_code& why) {
    return {ErrorCode::FileUnwritable, Subject::file(pathText(folder)), why.message()};
}

/// Whether the open folder is still the one of that name.
bool isStill(int open, const fs::path& folder) {
    struct stat held {};
    struct stat named {};
    return fstat(open, &held) == 0 && stat(folder.c_str(), &named) == 0 &&
           held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

/// For where file systems know no locks: no other process, on no other machine, has this name.
std::string ownName() {
    char host[256] = "";
    gethostname(host, sizeof host - 1);
    return std::string(host) + '-' + std::to_string(getpid());
}

}  // namespace

BatchFolder::BatchFolder(const fs::path& parent, const std::string& name)
    : folder_(parent / name), part_(parent / (name + ".part")) {}

BatchFolder::~BatchFolder() {
    if (lock_ >= 0) {  // not finished
        std::error_code ignored;
        fs::remove_all(part_, ignored);
        release();
    }
}

void BatchFolder::release() {
    close(lock_);
    lock_ = -1;
}

std::string BatchFolder::finished(const std::string& key) const {
    auto line = readFile(folder_ / kBatchRecord);
    if (!line) {
        return {};
    }
    const RecordHead head = headOf(*line);
    const bool isThere = std::ranges::all_of(head.outputs, [this](const std::string& output) {
        std::error_code ignored;
        return fs::exists(folder_ / output, ignored);
    });
    return head.key == key && isThere && !head.isWorthAnotherTry ? std::move(*line) : std::string();
}

Result<bool> BatchFolder::claim(const std::function<bool()>& isEnough) {
    while (!isEnough()) {
        std::error_code trouble;
        fs::create_directories(part_, trouble);
        if (trouble) {
            return cannotWrite(part_, trouble);
        }
        lock_ = open(part_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (lock_ < 0 && errno == ENOENT) {
            continue;  // another has just put it in its place
        }
        if (lock_ < 0) {
            return cannotWrite(part_, {errno, std::generic_category()});
        }
        const int fault = flock(lock_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
        const bool isTaken = fault == EWOULDBLOCK;
        if (fault == 0 && isStill(lock_, part_)) {
            return true;
        }
        if (fault == ENOLCK || fault == EOPNOTSUPP || fault == EINVAL || fault == ENOSYS) {
            return claimWithoutLock();
        }
        release();
        if (isTaken) {
            std::this_thread::sleep_for(kBetweenLooks);
        }
    }
    return false;
}

Result<bool> BatchFolder::claimWithoutLock() {
    std::error_code trouble;
    fs::remove(part_, trouble);  // empty; one that is not, another program left
    part_.replace_filename(pathText(folder_.filename()) + '.' + ownName() + ".part");
    fs::create_directories(part_, trouble);
    return trouble ? Result<bool>(cannotWrite(part_, trouble)) : Result<bool>(true);
}

Result<void> BatchFolder::clear() const {
    std::error_code trouble;
    for (const fs::directory_entry& left : fs::directory_iterator(part_, trouble)) {
        fs::remove_all(left.path(), trouble);
    }
    return trouble ? Result<void>(cannotWrite(part_, trouble)) : Result<void>();
}

Result<void> BatchFolder::finish(const std::string& record) {
    if (auto written = writeFile(part_ / kBatchRecord, record); !written) {
        return written;
    }
    std::error_code trouble;
    fs::remove_all(folder_, trouble);  // of another version, or one that was worth another try
    fs::rename(part_, folder_, trouble);
    if (trouble == std::errc::directory_not_empty || trouble == std::errc::file_exists) {
        fs::remove_all(part_, trouble);  // without locks: another has just put its own there
    }
    if (trouble) {
        return cannotWrite(folder_, trouble);
    }
    release();
    return {};
}

}  // namespace toile::app
