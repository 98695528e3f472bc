// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/derivation.h"

#include <unordered_map>
#include <utility>

#include "app/document/disposal.h"
#include "app/render/scene_builder.h"
#include "core/pipeline/garment_flattener.h"

namespace toile::app {
namespace {

/// Of the time to read a garment, about, until it is read, and until it is there.
constexpr double kReadingShare = 0.4, kDrawingShare = 0.97;

/// The results of those pieces of a garment that were in another; null for the others.
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

/// Takes other results in.
void become(Derivation& made, PieceResults results) {
    made.motions = flatMotions(made.derived.results, results);
    made.derived.results = std::move(results);
}

}  // namespace

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
    }
    Derived& derived = derivation.derived;
    derived.inputs = {state.inputs.files, resolveNames(state.inputs.loading, *garment)};
    derived.garment = garment;
    if (!before.results.empty()) {  // else nothing is flat yet, and all is to be
        derived.results = carriedResults(before.results, *garment);
    }
    return derivation;
}

Result<Derived> readGarment(const std::vector<std::filesystem::path>& paths,
                            const LoadOptions& loading, Progress& progress) {
    progress.setShare(0, kReadingShare);
    const Result<ReadFiles> files = readFiles(paths, progress);
    if (!files) {
        return files.error();
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

void flatten(Derivation& made, const FlattenOptions& options, GarmentFlattener& flattener,
             Progress& progress) {
    become(made,
           flattener.flatten(*made.derived.garment, options, progress, 0, made.derived.results));
}

void settle(Derivation& made, GarmentFlattener& flattener, Progress& progress) {
    become(made, flattener.settle(made.derived.results, progress));
}

void draw(Derived& derived, Progress& progress) {
    derived.pattern =
        std::make_shared<const Pattern>(makePattern(*derived.garment, derived.results));
    derived.scene = buildScene(*derived.garment, derived.results, progress);
    derived.bytes = bytesOf(*derived.scene);
    for (const auto& result : derived.results) {
        if (result && result->flat) {
            derived.bytes += static_cast<std::size_t>(result->flat->Q.size()) * sizeof(double);
        }
    }
}

SettingsById settingsAfter(const Derivation& made, SettingsById settings,
                           const std::vector<PieceSettings>& before) {
    const Garment& garment = *made.derived.garment;
    if (made.hasOtherGarment && !made.carried.empty()) {
        carrySettings(settings, before, made.carried, garment);
    }
    if (made.motions.empty()) {
        return settings;
    }
    std::vector<PieceSettings> placed;
    for (const auto& piece : garment.pieces) {
        placed.push_back(settings[piece->id]);
    }
    placed = placedSettings(std::move(placed), made.derived.results, made.motions);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        settings[garment.pieces[i]->id] = std::move(placed[i]);
    }
    return settings;
}

}  // namespace toile::app
