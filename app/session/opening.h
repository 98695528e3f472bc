// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/toile/pipeline.h"

namespace toile::app {

/// A garment that is being read to replace the open one, and whether it may:
///
///     nothing ──begin──▶ being read ──arrive──▶ asked about ──yes──▶ open
///                             │ stop, begin         │ begin: the answer comes too late
///
/// The user is asked only if the open garment was edited meanwhile.
class Opening {
public:
    using Paths = std::vector<std::filesystem::path>;
    using Next = std::function<void()>;
    using Ask = std::function<void(Next)>;

    /// Files that a job reads.
    struct Files {
        Paths paths;
        LoadOptions loading;
    };

    /// Files are being read; replaces an earlier reading.
    void begin() {
        files_.reset();
        active_ = true;
        edited_ = false;
        ++number_;
    }
    void begin(Files files) {
        begin();
        files_ = std::move(files);
    }
    /// Nothing is read any more.
    void stop() {
        files_.reset();
        active_ = false;
    }
    bool isActive() const { return active_; }
    /// None if something else is read, or nothing.
    std::optional<Files>& files() { return files_; }
    const std::optional<Files>& files() const { return files_; }

    void noteEdit() { edited_ = true; }
    void setAsk(Ask ask) { ask_ = std::move(ask); }
    /// Reading has ended. Call the returned function when nothing is being read any more: it calls
    /// `open`, at once or after the user agrees, unless something else was begun meanwhile.
    Next arrive(Next open) {
        stop();
        Next once = [this, open = std::move(open), number = number_] {
            if (number == number_) {
                ++number_;  // one answer opens only once
                open();
            }
        };
        if (!std::exchange(edited_, false) || !ask_) {
            return once;
        }
        return [this, once = std::move(once)] { ask_(once); };
    }

private:
    std::optional<Files> files_;
    bool active_ = false;
    bool edited_ = false;  ///< since `begin`
    int number_ = 0;       ///< of the last `begin`
    Ask ask_;
};

}  // namespace toile::app
