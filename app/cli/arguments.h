// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/batch_arguments.h"
#include "app/cli/marker_arguments.h"
#include "app/document/view_state.h"
#include "core/base/units.h"
#include "core/formats/export_options.h"
#include "core/garment/fabric.h"
#include "core/project/project.h"
#include "core/prove/proof_settings.h"
#include "core/toile/pipeline.h"

namespace toile::app {

/// What was typed for `toile prove`, beside the pattern's file.
struct ProveArguments {
    std::optional<FileUnit> patternUnit{};  ///< of the pattern's file
    ProofPlan typed{};                      ///< as far as it was typed: see `proofPlanOf`
    /// What of it was typed: each takes it over into what a project says.
    std::vector<void (*)(const ProofPlan& typed, ProofPlan& plan)> stated{};
    double scale = 1;  ///< of the pattern
    double sewn = 1;   ///< of pictures: the garment from as designed, 0, to as sewn, 1
    int rounds = 0;    ///< in which the pattern is improved; 0: it is not
    std::filesystem::path report{};
};

/// What is typed for `ProofPlan::body` where it is none, whatever a project says.
inline constexpr const char* kNoBody = "none";

/// What a picture is to show, for `toile render`.
struct PictureArguments {
    int width = 1600, height = 800;  ///< pixels, within kMinPicture and kMaxPicture
    ViewsShown views = ViewsShown::Both;
    std::optional<ViewDirection> direction{};  ///< none: as the window begins
    double morph = 0;                          ///< 0 to 1
    bool wireframe = false, xray = false, seams = true;
    std::optional<bool> bar{};  ///< none: where the overlay is measured
    bool dark = false;
    /// Pixels of a square for file managers, which wins over the size: the garment alone. 0: no
    /// thumbnail.
    int thumbnail = 0;
};

inline constexpr int kMinPicture = 16, kMaxPicture = 8192;

/// Width and height, as in "1600x800". @return what is wrong, or nothing
std::string readPictureSize(const std::string& typed, PictureArguments& picture);
/// From where the garment is seen: the name of a side, or two angles in degrees, as in "30,10".
/// @return what is wrong, or nothing
std::string readPictureLook(const std::string& typed, PictureArguments& picture);

/// What was typed of how pieces are flattened; nothing where it was not.
struct StatedOptions {
    std::optional<Method> method{};
    std::optional<Quality> quality{};
    std::optional<BoundarySolver> boundarySolver{};
    std::optional<FreeBoundary> freeBoundary{};
    std::optional<StretchOutline> stretchOutline{};
    std::optional<double> authalic{};
    std::optional<Fairing> fairing{};
    bool trueSeams = false;
    std::optional<Mirror> mirror{};
    bool byHalf = false;                       ///< every piece, in files; asks for mirrored pieces
    std::optional<double> allowance{}, hem{};  ///< AllowanceWidths; mm
    std::optional<bool> notches{};             ///< placed by themselves, or none
    std::optional<GrainRule> grain{};
    bool pattern = false;                       ///< `withPattern`
    std::optional<std::string> size{}, date{};  ///< LabelTexts

    /// These options where something was typed, the given ones else.
    FlattenOptions over(FlattenOptions options) const;
    LineSettings over(LineSettings lines) const;

    bool operator==(const StatedOptions&) const = default;
};

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
inline constexpr int kMaxThreads = 64;

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
