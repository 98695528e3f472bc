// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/cli/serve_request.h"
#include "core/base/progress.h"

namespace toile::app {

/// The garment that `toile serve` works on, and what is asked of it, one request after the other.
/// Says nothing and starts nothing by itself. Not thread-safe.
class ServeSession {
public:
    ServeSession();
    ~ServeSession();
    ServeSession(const ServeSession&) = delete;
    ServeSession& operator=(const ServeSession&) = delete;

    /// Does what is asked; the line that answers. Never throws. What fails or is cancelled leaves
    /// the garment as it was. `cancel` and `quit` are for whoever runs several requests: here they
    /// do nothing.
    /// Cost: that of the command of the same name.
    std::string answer(const ServeRequest& request, Progress& progress);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace toile::app
