// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/document/view_state.h"
#include "core/toile/pipeline.h"

namespace toile::app {

struct Arguments;

struct WindowOptions {
    std::vector<std::filesystem::path> files;  ///< opened as one garment
    LoadOptions load;                          ///< options for reading, dividing and cutting
    std::filesystem::path seams;               ///< a file of cuts and ease; may be empty
    /// If set: load, flatten, wait for the views, write a picture of the whole window and exit.
    std::filesystem::path screenshot;
    std::optional<Overlay> overlay;  ///< overrides the default or the project's overlay
    FlattenOptions flattening;
    std::optional<Panel> panel;       ///< the list in front; nullopt: as last used
    int width = 1600, height = 1000;  ///< of the screenshot, logical pixels
};

/// Runs the window until it is closed. Needs a display.
/// @return exit status: 0; 3 if there is no display; with `screenshot` also 3 if the garment could
///         not be read or the picture not written
int runWindow(int argc, char** argv, const WindowOptions& options);

/// Runs `toile render`: reads and flattens as `toile flatten` does, draws the views without a
/// window and writes them as PNG. Notes and errors go to stderr, a sentence each. Never throws.
/// @return exit status as of the other commands; 3 also where nothing can be drawn here
int runRender(int argc, char** argv, const Arguments& typed);

}  // namespace toile::app
