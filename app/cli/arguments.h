// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/batch_arguments.h"
#include "app/cli/marker_arguments.h"
#include "app/cli/picture_arguments.h"
#include "app/cli/prove_arguments.h"
#include "app/cli/stated_options.h"
#include "app/document/view_state.h"
#include "core/export/export_options.h"
#include "core/garment/fabric.h"
#include "core/pipeline/pipeline.h"
#include "core/project/project.h"

namespace toile::app {

/// What options are about.
enum OptionGroup : unsigned {
    kForTerminal = 0,   ///< what is printed, the exit status, pictures
    kInputFiles = 1,    ///< files to read
    kReading = 2,       ///< how they are read, divided and cut
    kFlattening = 4,    ///< how pieces are flattened and drawn
    kThreads = 8,       ///< how many threads work
    kOutputFiles = 16,  ///< files to write
    kExporting = 32,    ///< how they are written
    kSewing = 64,       ///< what is sewn in a proof, and how
    kEveryOption = ~0U,
};

/// Threads that work at one garment; OpenBLAS has memory for no more.
inline constexpr int kMostThreads = 64;

/// What the user typed, parsed and checked.
struct Arguments {
    enum class Command {
        Window,  ///< no command, perhaps files: open the window
        Flatten,
        Compare,
        Check,
        Info,
        Render,
        Walk,
        Marker,
        Prove,
        Batch,
        Serve,
        Message,  ///< help, version or a usage error: print `message` and end with `status`
    };

    Command command = Command::Window;
    std::vector<std::filesystem::path> inputs;
    std::vector<std::filesystem::path> outputs;
    /// But for the seams file, which the command reads.
    LoadOptions load{.cutStyle = CutStyle::Auto};
    std::filesystem::path seams;
    bool advice = false;               ///< info: which cuts would do most
    bool json = false;                 ///< info, compare, check, walk, prove: as JSON
    bool markdown = false;             ///< compare: as Markdown
    bool perPiece = false;             ///< compare: a table per piece too
    bool isProving = false;            ///< compare, check: sew the patterns back together too
    std::filesystem::path pattern{};   ///< compare: with this pattern from a file; prove: sew it
    bool ledger = false;               ///< flatten: print the seams
    bool failOnDoubt = false;          ///< flatten, check: status 1 where there is a doubt
    ExportOptions exporting{};         ///< flatten: of the files to write
    StatedOptions stated{};            ///< how pieces are flattened, as far as it was typed
    FlattenOptions options;            ///< the same, with what holds where nothing was typed
    LineSettings lines{};              ///< likewise, how outlines are drawn
    std::vector<Method> methods;       ///< compare: each once, in the order typed
    std::filesystem::path screenshot;  ///< window: save a picture of itself and end
    std::optional<Overlay> overlay;    ///< window, render: what is painted on the cloth
    std::optional<Panel> panel;        ///< window: the list in front
    PictureArguments picture;          ///< render
    MarkerArguments marker{};          ///< marker
    ProveArguments prove{};            ///< prove
    BatchArguments batch{};            ///< batch
    int threads = 0;                   ///< that flatten a garment; 0: as the machine has cores
    std::optional<Fabric> fabric{};    ///< check: typed, or a project's
    std::optional<Project> project{};  ///< that the inputs are of, once `withProject` has read it

    std::string message;
    int status = 0;
    std::optional<Error> error{};  ///< what the message says, where that is no wrong usage

    bool isMessage() const { return command == Command::Message; }
};

/// Parses the command line. Never exits and never throws; wrong usage comes back as a Message with
/// status 2. Cost: negligible.
/// @param taken  of `OptionGroup`: options of other groups are wrong usage
Arguments parseArguments(int argc, const char* const* argv, unsigned taken = kEveryOption);

}  // namespace toile::app
