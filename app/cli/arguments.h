// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/document/view_state.h"
#include "core/pipeline/pipeline.h"

namespace toile {

/// What the user typed, parsed and checked.
struct Arguments {
    enum class Command {
        Window,  ///< no command, perhaps files: open the window
        Flatten,
        Compare,
        Info,
        Message,  ///< help, version or a usage error: print `message` and end with `status`
    };

    Command command = Command::Window;
    std::vector<std::filesystem::path> inputs;
    std::vector<std::filesystem::path> outputs;
    LoadOptions load;  ///< but for the seams file, which the command reads
    std::filesystem::path seams;
    bool json = false;      ///< info, compare: as JSON
    bool markdown = false;  ///< compare: as Markdown
    bool perPiece = false;  ///< compare: a table per piece too
    bool ledger = false;    ///< flatten: print the seams
    FlattenOptions options;
    std::vector<Method> methods;         ///< compare: each once, in the order typed
    std::filesystem::path screenshot;    ///< window: save a picture of itself and end
    Overlay overlay = Overlay::Checker;  ///< window: what is painted on the cloth at first
    std::optional<Panel> panel;          ///< window: the list in front

    std::string message;
    int status = 0;
};

/// Parses the command line. Never exits and never throws; wrong usage comes back as a Message with
/// status 2. Cost: negligible.
Arguments parseArguments(int argc, const char* const* argv);

}  // namespace toile
