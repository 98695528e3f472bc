// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"

namespace toile::app {

/// The record in a garment's folder; it is written last.
inline constexpr const char* kBatchRecord = "garment.json";

/// The folder of one garment while it is being made. It is made beside, as NAME.part, and renamed:
/// NAME is there whole or not at all, whatever is killed when. Of several processes, on one machine
/// or on a file system that knows locks, one makes it and the others wait; without locks each makes
/// its own, NAME.HOST-PID.part, and one of them stays.
class BatchFolder {
public:
    BatchFolder(const std::filesystem::path& parent, const std::string& name);
    ~BatchFolder();
    BatchFolder(const BatchFolder&) = delete;
    BatchFolder& operator=(const BatchFolder&) = delete;

    /// The record's line where the garment is finished; empty where it is not, or worth another
    /// try.
    std::string finished(const std::string& key) const;

    /// Waits until the folder is this process's to make. @param isEnough  asked ten times a second;
    /// true: give up  @return whether it is. Errors: FileUnwritable.
    Result<bool> claim(const std::function<bool()>& isEnough);
    /// Takes away what is in it. Precondition: claimed.
    Result<void> clear() const;
    /// Writes the record and puts the folder in its place. Precondition: claimed.
    Result<void> finish(const std::string& record);

    const std::filesystem::path& part() const { return part_; }

private:
    Result<bool> claimWithoutLock();
    void release();

    std::filesystem::path folder_, part_;
    int lock_ = -1;
};

}  // namespace toile::app
