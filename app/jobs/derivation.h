// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/document/document_state.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/project/piece_settings.h"
#include "core/project/place_pieces.h"

namespace toile {
class GarmentFlattener;
}  // namespace toile

namespace toile::app {

/// What follows from a state, and how settings of its pieces are carried over. Nothing
/// here touches the document: any thread may work on a derivation of its own.
struct Derivation {
    Derived derived;
    bool hasOtherGarment = false;
    std::vector<CarriedFrom> carried{};                ///< of another garment
    std::vector<std::optional<FlatMotion>> motions{};  ///< of other results
    std::vector<std::optional<double>> grains{};       ///< by LineSettings::grain; else empty
    /// Of another garment, per piece: its usual material, if that has changed.
    std::vector<std::optional<std::string>> materials{};
};

/// The garment of the state, without a scene; flat is what was so before. Errors: of `makeGarment`.
/// @param before    what was derived last, and the settings of its pieces
Result<Derivation> deriveGarment(const DocumentState& state, const Derived& before,
                                 const std::vector<PieceSettings>& settingsBefore,
                                 Progress& progress);
/// Reads files and makes their garment, with its scene. Errors: of `readFiles` and `makeGarment`.
/// @param faces  gets how many the files have as soon as they are read; may be null
Result<Derived> readGarment(const std::vector<std::filesystem::path>& paths,
                            const LoadOptions& loading, Progress& progress,
                            std::atomic<int>* faces = nullptr);
/// Makes all of it flat, as the state asks. @param onPiece  called for each piece (OnPiece)
void flatten(Derivation& made, const DocumentState& state, GarmentFlattener& flattener,
             Progress& progress,
             const std::function<void(int done, int count, const Piece& begun)>& onPiece = {});
/// Takes out of the pattern what the settings leave out, and nothing else: nothing is flattened.
/// @param settings  one per piece
void leaveOut(Derivation& made, const std::vector<PieceSettings>& settings);
/// Puts cold results in the place of warm ones.
void settle(Derivation& made, GarmentFlattener& flattener, Progress& progress);
/// Settings of the pieces of a new garment, in the user's language.
SettingsById settingsOfNew(const Garment& garment);
/// What the state says of the pieces, after a derivation: pieces stay where they are on the sheet,
/// and those without a place, or without a grain where there is a rule for it, get one; where none
/// has a place yet, they lie in rows, none wider than a cloth of the pieces in it. What a piece is
/// cut from follows its layer, unless the user has set it. Idempotent.
/// @param before  settings of the pieces before, in their order
SettingsById settingsAfter(const Derivation& made, const DocumentState& state,
                           const std::vector<PieceSettings>& before);
/// Makes its pattern and its scene; what the scene there is has of the same results is kept.
void draw(Derived& derived, Progress& progress);

}  // namespace toile::app
