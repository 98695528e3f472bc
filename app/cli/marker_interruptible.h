// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

#include "core/base/progress.h"

namespace toile::app {

/// While there is one, Ctrl-C ends the work and not the program. One at a time.
class Interruptible {
public:
    explicit Interruptible(Progress& progress) {
        worked = &progress;
        before_ = std::signal(SIGINT, [](int) { worked->cancel(); });
    }
    ~Interruptible() { std::signal(SIGINT, before_); }
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;

private:
    static inline Progress* worked = nullptr;  // for the signal, which knows nobody
    void (*before_)(int);
};

}  // namespace toile::app
