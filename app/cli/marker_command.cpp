// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/input.h"
#include "app/cli/marker_interruptible.h"
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

namespace toile::app {
namespace {

constexpr double kBetweenLines = 1;  // s, of those that say how far the search is

/// The settings with their hides.
Result<MarkerSettings> withHides(const MarkerArguments& typed, std::ostream& err) {
    MarkerSettings settings = typed.settings;
    for (const auto& path : typed.hides) {
        auto hide = readHide(path);
        if (!hide) {
            return hide.error();
        }
        for (const Wording& note : hide->notes) {
            err << "toile: " << path.string() << ": " << shownText(note) << '\n';
        }
        settings.hides.push_back(std::make_shared<const Hide>(std::move(hide->hide)));
    }
    return settings;
}

/// What a project says of this material, and what was typed.
MarkerPlan planOf(const Arguments& arguments, const std::string& material,
                  const MarkerSettings& typed) {
    MarkerPlan plan;
    if (arguments.project) {
        const auto saved = arguments.project->markers.find(material);
        plan = saved == arguments.project->markers.end() ? plan : saved->second;
    }
    plan.settings = over(std::move(plan.settings), arguments.marker, typed);
    return plan;
}

/// With a first nest. Ctrl-C gives that up, where it ends a search only.
Result<MarkerNester> begun(const std::shared_ptr<const Pattern>& pattern,
                           const std::string& material, const Fabric& fabric,
                           const MarkerPlan& plan, int threads) {
    Progress progress;
    const Interruptible interruptible(progress);
    return MarkerNester::make(pattern, material, fabric, plan.settings, plan.kept, progress,
                              threads);
}

void search(MarkerNester& nester, const MarkerArguments& typed, Progress& progress,
            std::ostream& err) {
    const Interruptible interruptible(progress);
    const Stopwatch watch;
    double said = 0;
    while (!nester.best().isOptimal && !progress.isCancelled() &&
           isToGoOn(typed, nester.best().rounds, watch.seconds())) {
        nester.step(progress);
        if (typed.seconds && watch.seconds() >= said + kBetweenLines) {
            said = watch.seconds();
            err << "toile: " << fixed(said, 0) << " s, " << counted(nester.best().rounds, "round")
                << ": " << fixed(nester.best().length, 1) << " mm\n";
        }
    }
}

/// "marker-silk.pdf" where there are several. @param ending  "-silk", or nothing
std::filesystem::path pathOf(const std::filesystem::path& output, const std::string& ending) {
    return ending.empty() ? output : exportedPath(output, ending + std::string(endingOf(output)));
}

/// What is put to the outputs' names for each material, so that no two are the same.
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

/// What was read must not be written over, or nothing.
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

/// What cannot be laid as it was typed, or nothing.
std::string wrongInPlans(const Arguments& arguments, const std::vector<std::string>& materials,
                         const Pattern& pattern, const MarkerSettings& typed) {
    for (const std::string& material : materials) {
        const MarkerPlan plan = planOf(arguments, material, typed);
        if (std::string wrong = wrongTogether(typed, plan.settings); !wrong.empty()) {
            return wrong;
        }
    }
    for (const auto& [name, grade] : typed.grades) {
        if (std::ranges::find(pattern.pieces, name, &PatternPiece::name) == pattern.pieces.end()) {
            return "--grade names a piece that does not exist: \"" + name + "\"";
        }
    }
    return {};
}

void printMarker(const ClothMarker& marker, const Pattern& pattern, const MarkerArguments& typed,
                 std::ostream& out, std::ostream& err) {
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
        err << "toile: " << shownText(note) << '\n';
    }
}

Result<void> writeMarker(const Arguments& arguments, const Garment& garment,
                         const PieceResults& results, const MadeMarker& made,
                         const std::string& ending, std::ostream& out) {
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
    }
    return {};
}

}  // namespace

int runMarker(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    if (isNestInstance(arguments.inputs.front())) {
        return runMarkerOfInstance(arguments, out, err);
    }
    const MarkerArguments& typed = arguments.marker;
    const auto said = withHides(typed, err);
    if (!said) {
        return refuse(said.error(), err);
    }
    Progress progress;
    const auto garment = readInput(arguments, progress, err);
    if (!garment) {
        return kExitUnreadable;
    }
    const PieceResults results = flattened(arguments, *garment, progress);
    int status = printProblems(*garment, err) ? kExitSomeFailed : kExitDone;
    status = printFailures(results, err) ? kExitSomeFailed : status;
    const Pattern whole = finished(arguments, *garment, results).laid.wholePattern;
    std::vector<std::string> materials = markerMaterials(patternOnCloth(whole, *said));
    if (typed.material) {
        if (std::ranges::find(materials, *typed.material) == materials.end()) {
            err << "toile: no piece is cut from \"" << *typed.material << "\"; choose "
                << quotedList(materials, materials.size()) << ".\n";
            return kExitUsage;
        }
        materials = {*typed.material};
    }
    if (materials.empty()) {
        err << "toile: no piece could be flattened, so there is no marker.\n";
        return kExitSomeFailed;
    }
    const std::vector<std::string> endings = endingsOf(materials, arguments.outputs);
    std::string wrong = wrongInPlans(arguments, materials, whole, *said);
    if (const auto lost = lostInput(arguments, endings); lost && wrong.empty()) {
        wrong = "\"" + lost->string() + "\" is an input and would be overwritten";
    }
    if (!wrong.empty()) {
        err << "toile: " << wrong << ".\n";
        return kExitUsage;
    }
    std::vector<MadeMarker> markers;
    for (std::size_t k = 0; k < materials.size(); ++k) {
        const std::string& material = materials[k];
        const MarkerPlan plan = planOf(arguments, material, *said);
        const auto pattern = std::make_shared<const Pattern>(patternOnCloth(whole, plan.settings));
        const Fabric fabric = fabricOf(material, pattern->materials,
                                       arguments.fabric.value_or(fabricPresets().front()));
        auto nester = begun(pattern, material, fabric, plan, typed.threads);
        if (!nester) {
            return refuse(nester.error(), err);
        }
        search(*nester, typed, progress, err);
        markers.push_back({pattern, plan.settings, nester->best()});
        const ClothMarker& marker = markers.back().marker;
        printMarker(marker, *pattern, typed, out, err);
        status = marker.isWhole ? status : kExitSomeFailed;
        if (const auto written =
                writeMarker(arguments, *garment, results, markers.back(), endings[k], out);
            !written) {
            return refuse(written.error(), err);
        }
    }
    if (!typed.report.empty()) {
        const auto written = writeFile(typed.report, writeMarkers(markers, typed.minutesPerMetre));
        if (!written) {
            return refuse(written.error(), err);
        }
    }
    out.flush();
    return out ? status : kExitUnreadable;
}

}  // namespace toile::app
