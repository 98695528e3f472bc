// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <optional>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace toile {

/// A slow piece of work. It takes a snapshot when it is made (GUI thread), works on that alone,
/// and hands its result over at the end. Made, finalized and destroyed on the GUI thread.
class Job {
public:
    virtual ~Job() = default;

    /// For the status bar, for example "Reading tee.obj".
    virtual QString title() const = 0;
    /// Document revision the result belongs to; a result of an older one is dropped. None: the
    /// result is good whatever has changed since.
    virtual std::optional<std::uint64_t> revision() const { return std::nullopt; }
    /// False where the work is short and half of it is worse than all: cancelling passes it by.
    virtual bool isCancellable() const { return true; }
    /// The work. On a worker: touches no widget and no document. Polls `progress` for cancelling
    /// and returns Cancelled then. May throw only for bugs and out of memory.
    virtual Result<void> process(Progress& progress) = 0;
    /// Takes the result over. On the GUI thread, only after `process` returned without an error.
    virtual void finalize() = 0;
};

}  // namespace toile
