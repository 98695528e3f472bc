// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command_line.h"
#include "core/base/characters.h"
#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/base/text.h"
#include "core/formats/drawing/marker_drawing.h"
#include "core/formats/export_file.h"
#include "core/formats/formats.h"
#include "core/formats/hide_file.h"
#include "core/formats/writers.h"
#include "core/marker/cloth_marker.h"
#include "core/nest/instance_file.h"
#include "core/nest/nest.h"

namespace toile::app {
namespace {

constexpr double kBetweenLines = 1;  // s, between progress messages
constexpr double kUsualMarkerSeconds = 5;

using Hides = std::vector<std::shared_ptr<const Hide>>;

/// Whether to continue: until the typed rounds are done or the time is up.
bool isToGoOn(const MarkerArguments& typed, int rounds, double seconds) {
    const bool hasRounds = !typed.rounds || rounds < *typed.rounds;
    const double most = typed.seconds.value_or(typed.rounds ? seconds + 1 : kUsualMarkerSeconds);
    return hasRounds && seconds < most;
}

/// The typed hides.
Result<Hides> readHides(const MarkerArguments& typed, Messages& messages) {
    Hides hides;
    for (const auto& path : typed.hides) {
        auto hide = readHide(path);
        if (!hide) {
            return hide.error();
        }
        for (const Wording& note : hide->notes) {
            messages.add(path.string() + ": " + shownText(note));
        }
        hides.push_back(std::make_shared<const Hide>(std::move(hide->hide)));
    }
    return hides;
}

/// The project's plan of a material with typed options on top of it.
MarkerPlan planOf(const Arguments& arguments, const std::string& material, const Hides& hides) {
    MarkerPlan plan;
    if (arguments.project) {
        const auto saved = arguments.project->markers.find(material);
        plan = saved == arguments.project->markers.end() ? plan : saved->second;
    }
    Arguments base = arguments;
    base.marker.settings = std::move(plan.settings);
    MarkerSettings& settings = base.marker.settings;
    if (arguments.isTyped("--width") || arguments.isTyped("--sheet") || !hides.empty()) {
        settings.width = 0;  // replaces the cloth
        settings.sheet.reset();
        settings.hides = hides;
    }
    plan.settings = withTyped(std::move(base)).marker.settings;
    return plan;
}

/// Starts a nester with a first layout. Ctrl-C cancels that; later it only ends the search.
Result<MarkerNester> begun(const std::shared_ptr<const Pattern>& pattern,
                           const std::string& material, const Fabric& fabric,
                           const MarkerPlan& plan, const MarkerArguments& typed) {
    Progress progress;
    const Interruptible interruptible(progress);
    return MarkerNester::make(pattern, material, fabric, plan.settings, plan.kept, progress,
                              typed.threads, typed.seconds);
}

void search(MarkerNester& nester, const MarkerArguments& typed, Progress& progress,
            Messages& messages) {
    const Interruptible interruptible(progress);
    const Stopwatch watch;
    double said = 0;
    while (!nester.best().isOptimal && !progress.isCancelled() &&
           isToGoOn(typed, nester.best().rounds, watch.seconds())) {
        nester.step(progress);
        if (typed.seconds && watch.seconds() >= said + kBetweenLines) {
            said = watch.seconds();
            messages.add(fixed(said, 0) + " s, " + counted(nester.best().rounds, "round") + ": " +
                         fixed(nester.best().length, 1) + " mm");
        }
    }
}

/// "marker-silk.pdf" for one of several. @param ending  "-silk", or empty
std::filesystem::path pathOf(const std::filesystem::path& output, const std::string& ending) {
    return ending.empty() ? output : exportedPath(output, ending + std::string(endingOf(output)));
}

/// Suffixes of the outputs for each material, chosen to be unique.
std::vector<std::string> endingsOf(const std::vector<std::string>& materials,
                                   const std::vector<std::filesystem::path>& outputs) {
    std::vector<std::string> endings(materials.size());
    UniqueNames taken;
    for (const auto& output : outputs) {
        taken.take(output.string());
    }
    for (std::size_t k = 0; materials.size() > 1 && k < materials.size(); ++k) {
        const std::string wanted = materials[k].empty() ? "" : "-" + slug(materials[k]);
        endings[k] = wanted;
        const auto isTaken = [&](const auto& output) {
            return !wanted.empty() && !taken.isFree(pathOf(output, endings[k]).string());
        };
        for (int number = 2; std::ranges::any_of(outputs, isTaken); ++number) {
            endings[k] = wanted + "-" + std::to_string(number);
        }
        for (const auto& output : outputs) {
            taken.take(pathOf(output, endings[k]).string());
        }
    }
    return endings;
}

/// An input that would be overwritten, if any.
std::optional<std::filesystem::path> lostInput(const Arguments& arguments,
                                               const std::vector<std::string>& endings) {
    std::vector<std::filesystem::path> inputs = arguments.inputs;
    inputs.insert(inputs.end(), arguments.marker.hides.begin(), arguments.marker.hides.end());
    for (const auto& output : arguments.outputs) {
        for (const std::string& ending : endings) {
            for (const auto& input : inputs) {
                std::error_code ignored;
                if (std::filesystem::equivalent(input, pathOf(output, ending), ignored)) {
                    return input;
                }
            }
        }
    }
    return std::nullopt;
}

/// The problem of the first plan that cannot be laid as typed; empty: none.
std::string wrongInPlans(const Arguments& arguments, const std::vector<std::string>& materials,
                         const Pattern& pattern, const Hides& hides) {
    for (const std::string& material : materials) {
        const MarkerPlan plan = planOf(arguments, material, hides);
        if (std::string wrong = wrongTogether(arguments, plan.settings); !wrong.empty()) {
            return wrong;
        }
    }
    for (const auto& [name, grade] : arguments.marker.settings.grades) {
        if (std::ranges::find(pattern.pieces, name, &PatternPiece::name) == pattern.pieces.end()) {
            return "--grade names a piece that does not exist: \"" + name + "\"";
        }
    }
    return {};
}

void printMarker(const ClothMarker& marker, const Pattern& pattern, const MarkerArguments& typed,
                 std::ostream& out, Messages& messages) {
    const MarkerFigures figures = markerFigures(pattern, marker);
    out << shownText(clothSentence(marker)) << ", " << counted(marker.rounds, "round")
        << (marker.isOptimal ? ", which is the shortest" : "") << "; "
        << counted(figures.copies, "piece") << ", " << fixed(figures.seamMetres, 1)
        << " m of seam, " << figures.notches << (figures.notches == 1 ? " notch" : " notches")
        << ", " << fixed(figures.cutMetres, 1) << " m to cut";
    if (typed.minutesPerMetre) {
        out << ", " << fixed(*typed.minutesPerMetre * figures.seamMetres, 0) << " min to sew";
    }
    out << '\n';
    for (const Wording& note : marker.notes) {
        messages.add(shownText(note));
    }
}

Result<void> writeMarker(const Arguments& arguments, const Garment& garment,
                         const PieceResults& results, const MadeMarker& made,
                         const std::string& ending, std::ostream& out, Messages& messages) {
    const ClothMarker& marker = made.marker;
    const DrawnMarker drawn =
        drawMarker(*made.pattern, marker, made.settings, {clothSentence(marker)});
    const ExportSource source(garment, results, drawn.laid, arguments.exporting, {},
                              arguments.lines, arguments.fabric.value_or(fabricPresets().front()),
                              drawn.drawing);
    for (const auto& output : arguments.outputs) {
        const auto written = exportFile(pathOf(output, ending), source);
        if (!written) {
            return written.error();
        }
        for (const std::filesystem::path& file : written->files) {
            out << "wrote " << file.string();
            if (written->readBack && file == written->files.front()) {
                out << "; " << readBackSentence(*written->readBack);
            }
            out << '\n';
        }
        for (const Wording& note : written->notes) {
            messages.add(shownText(note));
        }
    }
    return {};
}

/// Nests an instance of the nesting problem.
int nestInstance(const Arguments& arguments, std::ostream& out, Messages& messages) {
    const MarkerArguments& typed = arguments.marker;
    auto instance = readNestInstance(arguments.inputs.front());
    if (!instance) {
        return refuse(instance.error(), messages);
    }
    NestOptions options;
    options.seed = typed.settings.seed;
    options.gap = typed.settings.gap;
    options.border = typed.settings.border;
    options.threads = typed.threads;
    options.hasteAfter = typed.seconds.value_or(options.hasteAfter);
    const Stopwatch watch;
    Progress progress;
    const Interruptible interruptible(progress);
    auto nester = Nester::make(std::move(*instance), options, progress);
    if (!nester) {
        return refuse(nester.error(), messages);
    }
    const NestResult& best = nester->best();
    while (!best.optimal && !progress.isCancelled() &&
           isToGoOn(typed, best.rounds, watch.seconds())) {
        nester->step(progress);
    }
    out << "length " << fixed(best.length, 3) << " mm, use " << fixed(100 * best.use, 2) << " %, "
        << counted(best.rounds, "round") << (best.optimal ? ", which is the shortest" : "") << '\n';
    std::vector<std::filesystem::path> files = arguments.outputs;
    if (!arguments.report.empty()) {
        files.push_back(arguments.report);
    }
    for (const auto& path : files) {
        const std::string text = path == arguments.report
                                     ? nestReport(nester->instance(), options, best)
                                     : nestPicture(nester->instance(), best);
        if (const auto written = writeFile(path, text); !written) {
            return refuse(written.error(), messages);
        }
    }
    out.flush();
    return !out ? kExitUnreadable : best.valid ? kExitDone : kExitSomeFailed;
}

}  // namespace

int runMarker(const Arguments& arguments, std::ostream& out, Messages& messages) {
    if (isNestInstance(arguments.inputs.front())) {
        return nestInstance(arguments, out, messages);
    }
    const MarkerArguments& typed = arguments.marker;
    const auto hides = readHides(typed, messages);
    if (!hides) {
        return refuse(hides.error(), messages);
    }
    Progress progress;
    const auto garment = readInput(arguments, progress, messages);
    if (!garment) {
        return kExitUnreadable;
    }
    const PieceResults results = flattened(arguments, *garment, progress);
    int status = reportProblems(*garment, messages) ? kExitSomeFailed : kExitDone;
    status = reportFailures(results, messages) ? kExitSomeFailed : status;
    const Pattern whole = finished(arguments, *garment, results).laid.wholePattern;
    MarkerSettings onHides = typed.settings;
    onHides.hides = *hides;
    std::vector<std::string> materials = markerMaterials(patternOnCloth(whole, onHides));
    if (typed.material) {
        if (std::ranges::find(materials, *typed.material) == materials.end()) {
            messages.add("no piece is cut from \"" + *typed.material + "\"; choose " +
                         quotedList(materials, materials.size()) + ".");
            return kExitUsage;
        }
        materials = {*typed.material};
    }
    if (materials.empty()) {
        messages.add("no piece could be flattened, so there is no marker.");
        return kExitSomeFailed;
    }
    const std::vector<std::string> endings = endingsOf(materials, arguments.outputs);
    std::string wrong = wrongInPlans(arguments, materials, whole, *hides);
    if (const auto lost = lostInput(arguments, endings); lost && wrong.empty()) {
        wrong = "\"" + lost->string() + "\" is an input and would be overwritten";
    }
    if (!wrong.empty()) {
        return refuse(usageRefusal(wrong + "."), messages);
    }
    std::vector<MadeMarker> markers;
    for (std::size_t k = 0; k < materials.size(); ++k) {
        const std::string& material = materials[k];
        const MarkerPlan plan = planOf(arguments, material, *hides);
        const auto pattern = std::make_shared<const Pattern>(patternOnCloth(whole, plan.settings));
        const Fabric fabric = fabricOf(material, pattern->materials,
                                       arguments.fabric.value_or(fabricPresets().front()));
        auto nester = begun(pattern, material, fabric, plan, typed);
        if (!nester) {
            return refuse(nester.error(), messages);
        }
        search(*nester, typed, progress, messages);
        markers.push_back({pattern, plan.settings, nester->best()});
        const ClothMarker& marker = markers.back().marker;
        printMarker(marker, *pattern, typed, out, messages);
        status = marker.isWhole ? status : kExitSomeFailed;
        if (const auto written = writeMarker(arguments, *garment, results, markers.back(),
                                             endings[k], out, messages);
            !written) {
            return refuse(written.error(), messages);
        }
    }
    if (!arguments.report.empty()) {
        const auto written =
            writeFile(arguments.report, writeMarkers(markers, typed.minutesPerMetre));
        if (!written) {
            return refuse(written.error(), messages);
        }
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile::app
