// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/toile/pipeline.h"

namespace toile::app {

/// What is on its way to become the open garment, and whether it may take the place of what is open
/// when it is there:
///
///     nothing ──begin──▶ being read ──arrive──▶ asked about ──yes──▶ open
///                             │ stop, begin         │ begin: the answer comes too late
///
/// It is asked about only where the garment that is open was edited meanwhile.
class Opening {
public:
    using Paths = std::vector<std::filesystem::path>;
    using Next = std::function<void()>;
    using Ask = std::function<void(Next)>;

    /// A job reads these.
    struct Files {
        Paths paths;
        LoadOptions loading;
    };

    /// Something is read in place of whatever was before; what, only the job knows.
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
    /// Nothing comes.
    void stop() {
        files_.reset();
        active_ = false;
    }
    bool isActive() const { return active_; }
    /// None where something else is read, or nothing.
    std::optional<Files>& files() { return files_; }
    const std::optional<Files>& files() const { return files_; }

    void noteEdit() { edited_ = true; }
    void setAsk(Ask ask) { ask_ = std::move(ask); }
    /// It is there. What is returned has to be called once nothing is on its way any more: it calls
    /// `open`, at once or when the person has agreed, unless something else was begun meanwhile.
    Next arrive(Next open) {
        stop();
        Next once = [this, open = std::move(open), number = number_] {
            if (number == number_) {
                ++number_;  // an answer is good for one opening
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
    bool edited_ = false;  ///< since it was begun
    int number_ = 0;       ///< of what is read, or was last
    Ask ask_;
};

}  // namespace toile::app
