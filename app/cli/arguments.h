// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cli/option_archive.h"
#include "app/cli/refusal.h"
#include "app/document/view_state.h"
#include "core/base/units.h"
#include "core/formats/export_options.h"
#include "core/garment/fabric.h"
#include "core/marker/marker_settings.h"
#include "core/project/project.h"
#include "core/prove/proof_settings.h"
#include "core/toile/pipeline.h"

namespace toile::app {

/// Options of `toile prove` apart from the pattern file.
struct ProveArguments {
    std::optional<FileUnit> patternUnit{};  ///< of the pattern file
    ProofPlan plan{};                       ///< the project's, then typed options
    double scale = 1;                       ///< of the pattern
    double sewn = 1;                        ///< of pictures: 0 as designed, 1 as sewn
    int rounds = 0;                         ///< rounds of improving the pattern; 0: none
};

/// The content of a picture, for `toile render` and `toile prove`.
struct PictureArguments {
    int width = 1600, height = 800;  ///< pixels, within kMinPicture and kMaxPicture
    ViewsShown views = ViewsShown::Both;
    std::optional<ViewDirection> direction{};  ///< nullopt: the initial view
    double morph = 0;                          ///< 0 to 1
    bool wireframe = false, xray = false, seams = true;
    std::optional<bool> bar{};  ///< nullopt: if the overlay is measured
    bool dark = false;
    /// Width in pixels of a square picture of the garment for file managers, used instead of the
    /// size. 0: no thumbnail.
    int thumbnail = 0;
};

inline constexpr int kMinPicture = 16, kMaxPicture = 8192;

/// Options of `toile marker`.
struct MarkerArguments {
    std::optional<int> rounds;      ///< after which the search ends
    std::optional<double> seconds;  ///< search time, rounded up to the end of a round
    int threads = 0;                ///< 0: all cores
    MarkerSettings settings{};      ///< without hides, which the command reads
    std::vector<std::filesystem::path> hides;
    std::optional<std::string> material;  ///< the only one to lay; "": the garment's fabric
    std::optional<double> minutesPerMetre;
};

/// Options of `toile batch`.
struct BatchArguments {
    std::filesystem::path list{};                     ///< a garment per line; "-": standard input
    std::filesystem::path folder{};                   ///< for all results
    std::vector<std::string> formats{"json", "svg"};  ///< file extensions without dot
    double limitSeconds = 600;                        ///< wall clock, per garment; 0: none
    int memoryMib = 0;                                ///< per garment; 0: no limit
    int threads = 1;                                  ///< per garment
    /// The typed reading and flattening options with values. They are sorted as in the help: the
    /// typed order does not matter.
    Words words{};
};

/// Threads for one garment; OpenBLAS has no memory for more.
inline constexpr int kMaxThreads = 64;

/// A parsed and checked command line.
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
        Message,  ///< help or version: print `message`
    };

    Command command = Command::Window;
    std::string message;  ///< help or version
    TypedWords typed;     ///< determines everything else, together with a project

    std::vector<std::filesystem::path> inputs;
    std::vector<std::filesystem::path> outputs;
    /// Without the seams file, which the command reads.
    LoadOptions load{.cutStyle = CutStyle::Auto};
    std::filesystem::path seams;
    bool advice = false;               ///< info: recommended cuts
    bool json = false;                 ///< info, compare, check, walk, prove: as JSON
    bool markdown = false;             ///< compare: as Markdown
    bool perPiece = false;             ///< compare: a table per piece too
    bool isProving = false;            ///< compare, check: also sew the patterns back together
    std::filesystem::path pattern{};   ///< compare: the other pattern; prove: the one to sew
    std::filesystem::path report{};    ///< marker, prove: JSON to write
    bool ledger = false;               ///< flatten: print the seams
    bool failOnDoubt = false;          ///< flatten, check: exit status 1 if there is a warning
    ExportOptions exporting{};         ///< of the files to write
    FlattenOptions options;            ///< how pieces are flattened
    LineSettings lines{};              ///< how outlines are drawn
    bool byHalf = false;               ///< draw symmetric pieces by half, in files
    std::vector<Method> methods;       ///< compare: without duplicates, in the order typed
    std::filesystem::path screenshot;  ///< window: save a screenshot and exit
    std::optional<Overlay> overlay;    ///< window, render, prove: the overlay on the cloth
    std::optional<Panel> panel;        ///< window: the panel in front
    PictureArguments picture;          ///< render, prove
    MarkerArguments marker{};          ///< marker
    ProveArguments prove{};            ///< prove, compare, check
    BatchArguments batch{};            ///< batch
    int threads = 0;                   ///< for one garment; 0: all cores
    std::optional<Fabric> fabric{};    ///< typed, or the project's
    std::optional<Project> project{};  ///< of the inputs, set by `withProject`

    bool isTyped(std::string_view key) const { return typed.contains(key); }
};

/// A command of the program. The window has no command word.
struct CommandRow {
    Arguments::Command command;
    const char* word;
    const char* help;     ///< description without the last full stop
    const char* notes;    ///< below the options; may be empty
    const char* example;  ///< a complete line
    void (*describe)(OptionArchive& at, Arguments& arguments);
};

/// The window, and all commands in the order of the help.
std::span<const CommandRow> commandRows();

/// Applies the typed options on top of these settings: a project's settings keep their values
/// unless an option of the command was typed. Precondition: parsed.
Arguments withTyped(Arguments base);
/// Applies the project's settings for flattening, drawing and proving, then the typed options. A
/// project's stiffness belongs to its own fabric, so another typed fabric drops it.
Arguments withSettingsOf(const Project& project, Arguments arguments);

/// Whether an option of these groups was typed.
bool isAnyTyped(const Arguments& arguments, unsigned groups);

/// Parses the command line. Never exits and never throws. Refused: kWrongUsage. Cost: negligible.
/// @param taken  accepted `OptionGroup`s: options of other groups are wrong usage
Answer<Arguments> parseArguments(int argc, const char* const* argv, unsigned taken = kEveryOption);

/// The same for callers that pass command, files and options as words: `toile serve`, `toile
/// batch`, Python. A file name that starts with a dash is not taken for an option.
Answer<Arguments> typedWords(const char* command, const std::vector<std::string>& files,
                             const Words& words, unsigned taken);

/// Checks valid options together: options that need others, outputs that cannot be written or would
/// overwrite an input. Accesses the disk. @return the problem; empty if there is none
std::string wrongIn(const Arguments& arguments);

/// Checks typed marker options together with the settings of a material, which may come from a
/// project. @param settings  including their hides
std::string wrongTogether(const Arguments& arguments, const MarkerSettings& settings);

/// Whether a file is a picture by its extension: "x.png".
bool isPicture(const std::filesystem::path& file);
/// Whether a file is an instance of the nesting problem by its extension.
bool isNestInstance(const std::filesystem::path& file);

}  // namespace toile::app
