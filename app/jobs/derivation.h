// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/document/document_state.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/project/piece_settings.h"
#include "core/project/place_pieces.h"
#include "core/toile/toile.h"

namespace toile {
class GarmentFlattener;
}  // namespace toile

namespace toile::app {

class Document;

/// The results for a state, and how settings of its pieces carry over. Nothing here touches the
/// document: each thread may work on a derivation of its own.
struct Derivation {
    Derived derived;
    bool hasOtherGarment = false;
    std::vector<CarriedFrom> carried{};                ///< for another garment
    std::vector<std::optional<FlatMotion>> motions{};  ///< for other results
    std::vector<std::optional<double>> grains{};       ///< by LineSettings::grain; else empty
    /// For another garment, per piece: its usual material, if that has changed.
    std::vector<std::optional<std::string>> materials{};
};

/// One per piece of the garment.
std::vector<PieceSettings> settingsOf(const Garment& garment, const SettingsById& settings);

/// The garment of the state, without a scene, with the flat pieces that were known. Errors: of
/// `makeGarment`.
/// @param before    the last results, with the settings of their pieces
Result<Derivation> deriveGarment(const DocumentState& state, const Derived& before,
                                 const std::vector<PieceSettings>& settingsBefore,
                                 Progress& progress);
/// Reads files and makes their garment, with its scene. Errors: of `readFiles` and `makeGarment`.
/// @param faces  receives the number of faces when the files are read; may be null
Result<Derived> readGarment(const std::vector<std::filesystem::path>& paths,
                            const LoadOptions& loading, Progress& progress,
                            std::atomic<int>* faces = nullptr);
/// Flattens all pieces as the state asks. @param onPiece  called for each piece (OnPiece)
void flatten(Derivation& made, const DocumentState& state, GarmentFlattener& flattener,
             Progress& progress,
             const std::function<void(int done, int count, const Piece& begun)>& onPiece = {});
/// Removes from the pattern what the settings leave out; flattens nothing.
/// @param settings  one per piece
void leaveOut(Derivation& made, const std::vector<PieceSettings>& settings);
/// Replaces warm results by cold ones.
void settle(Derivation& made, GarmentFlattener& flattener, Progress& progress);
/// Settings of the pieces of a new garment, in the user's language.
SettingsById settingsOfNew(const Garment& garment);
/// Settings of the pieces after a derivation: pieces keep their places on the sheet, and those
/// without a place, or without a grain if there is a rule for it, get one. If none has a place yet,
/// they lie in rows, none wider than a cloth of its pieces. The material of a piece follows its
/// layer, unless the user has set it. Idempotent.
/// @param before  earlier settings of the pieces, in their order
SettingsById settingsAfter(const Derivation& made, const DocumentState& state,
                           const std::vector<PieceSettings>& before);
/// Makes pattern and scene; reuses the parts of the present scene that show the same results.
void draw(Derived& derived, Progress& progress);

/// A snapshot of the pattern for files.
class PatternNow {
public:
    /// @param only  the pieces to use; none: all
    /// @param settlingShare  share of the total time for flattening, if flat pieces are still warm
    PatternNow(const Document& document, std::set<int> only, double settlingShare = 0.7);

    /// Flattens the remaining pieces, lays the pattern out and passes it to `use`, a function of
    /// `(const ExportSource&, const Progress&)` to a Result.
    template <class Use>
    auto with(const ExportOptions& options, Progress& progress, const Use& use) const
        -> std::invoke_result_t<Use, const ExportSource&, const Progress&> {
        const FinishedPattern made = finished(progress);
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        return use(made.source(options, words_), progress);
    }

    /// True if files of both are the same, apart from the language.
    bool operator==(const PatternNow& other) const {
        return only_ == other.only_ && derived_ == other.derived_ && state_ == other.state_;
    }

private:
    FinishedPattern finished(Progress& progress) const;

    std::set<int> only_;
    double settlingShare_;
    Derived derived_;
    DocumentState state_;  ///< the parts that pieces and their drawing follow from
    DrawingWords words_;
};

}  // namespace toile::app
