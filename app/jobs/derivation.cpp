// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/derivation.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "app/document/disposal.h"
#include "app/document/document.h"
#include "app/render/scene_builder.h"
#include "app/text/error_text.h"
#include "core/pattern/piece_grain.h"
#include "core/pattern/target_lengths.h"
#include "core/project/layer_materials.h"
#include "core/project/piece_names.h"
#include "core/project/piece_settings.h"
#include "core/project/place_pieces.h"
#include "core/toile/garment_flattener.h"

namespace toile::app {
namespace {

/// Approximate shares of the time to read a garment: until its files are read, and until it is
/// made.
constexpr double kReadingShare = 0.4, kDrawingShare = 0.97;

/// The results of the pieces that two garments share; null for the others.
PieceResults carriedResults(const PieceResults& results, const Garment& after) {
    std::unordered_map<const Piece*, std::shared_ptr<const PieceResult>> known;
    for (const auto& result : results) {
        if (result) {
            known.emplace(result->piece.get(), result);
        }
    }
    PieceResults carried;
    for (const auto& piece : after.pieces) {
        const auto found = known.find(piece.get());
        carried.push_back(found == known.end() ? nullptr : found->second);
    }
    return carried;
}

std::size_t bytesOf(const FlatPiece& flat) {
    const std::size_t line = flat.line ? 3 * static_cast<std::size_t>(flat.line->points.rows()) : 0;
    return (static_cast<std::size_t>(flat.Q.size()) + line) * sizeof(double);
}

/// Replaces the results.
void become(Derivation& made, PieceResults results) {
    made.motions = flatMotions(made.derived.results, results);
    made.derived.results = std::move(results);
}

}  // namespace

std::vector<PieceSettings> settingsOf(const Garment& garment, const SettingsById& settings) {
    std::vector<PieceSettings> found;
    for (const auto& piece : garment.pieces) {
        const auto said = settings.find(piece->id);
        found.push_back(said == settings.end() ? PieceSettings{} : said->second);
    }
    return found;
}

Result<Derivation> deriveGarment(const DocumentState& state, const Derived& before,
                                 const std::vector<PieceSettings>& settingsBefore,
                                 Progress& progress) {
    Result<Garment> made = makeGarment(state.inputs, progress, before.inputs, before.garment.get());
    if (!made) {
        return made.error();
    }
    const auto garment =
        sharedForDisposal(std::make_unique<const Garment>(std::move(made).value()));
    Derivation derivation;
    derivation.hasOtherGarment = true;
    if (before.garment) {
        derivation.carried = carriedFrom(*before.garment, settingsBefore, before.results, *garment);
        const std::vector<Wording> was = usualMaterials(*before.garment),
                                   is = usualMaterials(*garment);
        for (std::size_t p = 0; p < is.size(); ++p) {
            const int from = derivation.carried[p].piece;
            if (is[p] == (from < 0 ? Wording() : was[static_cast<std::size_t>(from)])) {
                derivation.materials.emplace_back();  // the name may be in another language
            } else {
                derivation.materials.emplace_back(wordingText(is[p]).toStdString());
            }
        }
    }
    Derived& derived = derivation.derived;
    derived.inputs = {state.inputs.files, resolveNames(state.inputs.loading, *garment)};
    derived.garment = garment;
    if (!before.results.empty()) {  // otherwise nothing is flat yet
        derived.results = carriedResults(before.results, *garment);
        derived.lines = before.lines;
        if (!(state.lines == LineSettings{}) || drawsEase(*garment) || drawsEase(*before.garment)) {
            derived.lines.reset();  // segments and targets may differ
        }
    }
    return derivation;
}

Result<Derived> readGarment(const std::vector<std::filesystem::path>& paths,
                            const LoadOptions& loading, Progress& progress,
                            std::atomic<int>* faces) {
    progress.setShare(0, kReadingShare);
    const Result<ReadFiles> files = readFiles(paths, progress);
    if (!files) {
        return files.error();
    }
    for (const ReadFile& file : *files) {
        if (faces) {
            *faces += file.soup->faceCount();
        }
    }
    progress.setShare(kReadingShare, kDrawingShare);
    DocumentState state;
    state.inputs = {*files, loading};
    Result<Derivation> made = deriveGarment(state, {}, {}, progress);
    if (!made) {
        return made.error();
    }
    progress.setShare(kDrawingShare, 1);
    draw(made->derived, progress);
    return made->derived;
}

void flatten(Derivation& made, const DocumentState& state, GarmentFlattener& flattener,
             Progress& progress, const OnPiece& onPiece) {
    const Garment& garment = *made.derived.garment;
    const std::vector<PieceSettings> settings = settingsOf(garment, state.settings);
    const PieceResults before = made.derived.results;
    std::vector<Fabric> fabrics;
    PieceResults known(garment.pieces.size());  // a typed grain refers to their flat points
    std::vector<std::optional<double>> typed;
    for (std::size_t p = 0; p < settings.size(); ++p) {
        fabrics.push_back(fabricOf(settings[p].material, state.materials, state.fabric));
        const auto shown = std::ranges::find_if(before, [&](const auto& result) {
            return result && result->piece == garment.pieces[p] &&
                   result->fingerprint == settings[p].flat;
        });
        known[p] = shown == before.end() ? nullptr : *shown;
        typed.push_back(settings[p].grain);
    }
    become(made,
           withoutLeftOut(
               flattener.flatten(garment, state.options, progress, 0, before, state.lines, onPiece,
                                 pieceCloths(garment, state.lines.grain, fabrics, known, typed)),
               garment, settings));
    made.derived.lines = state.lines;
    made.derived.symmetry = flattener.symmetryOf(garment, state.lines);
    if (state.lines.grain) {
        made.grains = findGrains(garment, made.derived.results, made.derived.symmetry.get(),
                                 *state.lines.grain, fabrics);
    }
}

void leaveOut(Derivation& made, const std::vector<PieceSettings>& settings) {
    become(made, withoutLeftOut(made.derived.results, *made.derived.garment, settings));
}

void settle(Derivation& made, GarmentFlattener& flattener, Progress& progress) {
    if (!made.derived.lines) {
        return;  // of older lines: leave it as it was asked for then
    }
    become(made, flattener.settle(*made.derived.garment, made.derived.results, progress, 0,
                                  *made.derived.lines));
}

void draw(Derived& derived, Progress& progress) {
    derived.pattern = std::make_shared<const Pattern>(
        makePattern(*derived.garment, derived.results, derived.lines.value_or(LineSettings{}),
                    derived.symmetry));
    derived.scene = buildScene(*derived.garment, derived.results, progress, derived.pattern.get(),
                               derived.scene.get());
    derived.bytes = bytesOf(*derived.scene);
    for (const auto& result : derived.results) {
        if (result && result->flat) {
            derived.bytes += bytesOf(*result->flat);
            derived.bytes += result->exact ? bytesOf(*result->exact->flat) : 0;
        }
    }
}

SettingsById settingsOfNew(const Garment& garment) {
    SettingsById settings;
    const std::vector<Wording> materials = usualMaterials(garment);
    for (std::size_t p = 0; p < materials.size(); ++p) {
        if (!materials[p].empty()) {
            settings[garment.pieces[p]->id].material = wordingText(materials[p]).toStdString();
        }
    }
    return settings;
}

SettingsById settingsAfter(const Derivation& made, const DocumentState& state,
                           const std::vector<PieceSettings>& before) {
    SettingsById settings = state.settings;
    const Garment& garment = *made.derived.garment;
    if (made.hasOtherGarment && !made.carried.empty()) {
        carrySettings(settings, before, made.carried, garment);
        for (std::size_t p = 0; p < made.materials.size(); ++p) {
            PieceSettings& said = settings[garment.pieces[p]->id];
            if (made.materials[p] && !said.materialByHand) {
                said.material = *made.materials[p];
            }
        }
    }
    if (made.motions.empty()) {
        return settings;
    }
    std::vector<PieceSettings> placed;
    for (const auto& piece : garment.pieces) {
        placed.push_back(settings[piece->id]);
    }
    placed = placedSettings(std::move(placed), made.derived.results, made.motions,
                            made.derived.pattern.get(), state.materials, state.fabric);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (i < made.grains.size() && !placed[i].grain) {
            placed[i].grain = made.grains[i];
        }
        settings[garment.pieces[i]->id] = std::move(placed[i]);
    }
    return settings;
}

PatternNow::PatternNow(const Document& document, std::set<int> only, double settlingShare)
    : only_(std::move(only)),
      settlingShare_(settlingShare),
      derived_(document.derived()),
      state_(document.state()),
      words_(drawingWords()) {
    state_.markers = {};
    state_.proof = {};
    for (std::size_t i = 0; i < document.settings().size(); ++i) {
        // The state may already be without a piece that is still shown.
        state_.settings.try_emplace(document.garment()->pieces[i]->id, document.settings()[i]);
    }
}

FinishedPattern PatternNow::finished(Progress& progress) const {
    Derivation derivation{derived_};
    progress.setShare(0, settlingShare_);
    GarmentFlattener flattener;
    settle(derivation, flattener, progress);
    if (progress.isCancelled()) {
        return {};
    }
    progress.setShare(settlingShare_, 1);
    SettingsById settings = settingsAfter(derivation, state_, {});
    std::vector<PieceSettings> ofPieces;
    for (const auto& piece : derived_.garment->pieces) {
        ofPieces.push_back(settings[piece->id]);
    }
    for (std::size_t i = 0; i < ofPieces.size(); ++i) {
        // A piece that has just been included again is not flat yet, and so not shown.
        const bool isShown = !isLeftOut(*derivation.derived.results[i]) &&
                             (only_.empty() || only_.contains(static_cast<int>(i)));
        ofPieces[i].leftOut = ofPieces[i].leftOut || !isShown;
    }
    Garment garment = named(*derived_.garment, state_.labels);
    PieceResults results =
        withoutLeftOut(resultsFor(garment, derivation.derived.results), garment, ofPieces);
    return makePattern(std::move(garment), std::move(results),
                       {.lines = derivation.derived.lines.value_or(LineSettings{}),
                        .fabric = state_.fabric,
                        .materials = state_.materials,
                        .pieces = std::move(ofPieces)},
                       derivation.derived.symmetry);
}

}  // namespace toile::app
