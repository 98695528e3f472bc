// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

namespace toile::app {

/// Calls this on another thread where the window's thread asks for it; elsewhere at once.
void doElsewhere(std::function<void()> work);

/// Shares a large value so that it is never destroyed on the window's thread, whoever lets go of it
/// last: giving back some hundred megabytes takes longer than the window may be held up.
template <class Value>
std::shared_ptr<Value> sharedForDisposal(std::unique_ptr<Value> value) {
    return std::shared_ptr<Value>(value.release(),
                                  [](Value* old) { doElsewhere([old] { delete old; }); });
}

}  // namespace toile::app
