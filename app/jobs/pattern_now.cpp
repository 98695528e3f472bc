// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/pattern_now.h"

#include <utility>

#include "app/document/document.h"
#include "app/jobs/derivation.h"
#include "app/text/error_text.h"
#include "core/project/piece_names.h"
#include "core/project/piece_settings.h"
#include "core/toile/garment_flattener.h"

namespace toile::app {

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
