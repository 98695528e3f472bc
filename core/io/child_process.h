// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/soup.h"

namespace toile::io {

/// Limits of a child process.
struct ChildLimits {
    int seconds = 0;            ///< of processor time
    std::uintmax_t memory = 0;  ///< bytes of address space beyond the program's, and of output
};

enum class ChildEnd { Finished, BeyondLimits, Crashed, Cancelled };

struct ChildResult {
    ChildEnd end = ChildEnd::Crashed;
    /// The result of the work, if it finished; incomplete if other code has reaped the child.
    std::string output{};
};

/// Runs work in a child process, which has a copy of this program's memory, and returns the bytes
/// that the work returns. If a library crashes, never returns or takes too much memory, only the
/// child is affected. The child prints nothing, writes no file, and ends with its parent.
/// @param work      must not take locks that other threads may hold; std::bad_alloc counts as
///                  BeyondLimits, any other exception as a crash
/// @param progress  if it is cancelled, the child is killed at once
/// If no child can be started, it counts as crashed.
/// Cost: that of the work, a fork, and a copy of the output. Any thread.
ChildResult runInChild(const std::function<std::string()>& work, const ChildLimits& limits,
                       const Progress& progress);

/// A soup without text, hash and up axis, or an error, as bytes for another process of the same
/// program; the unit without its reason, problems with code and text only.
std::string packedSoup(Result<PolygonSoup> soup);

/// Unpacks the soup or the error. Bytes that violate the invariants of a soup are MalformedFile.
/// @param name  the file, for messages
Result<PolygonSoup> unpackedSoup(std::string_view bytes, const std::string& name);

}  // namespace toile::io
