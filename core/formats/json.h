// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/json_fields.h"
#include "core/base/wording.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/pattern.h"
#include "core/seam/seam_measure.h"
#include "core/symmetry/symmetry.h"

/// The parts that reports and descriptions of a garment share. Include in writers only: the JSON
/// library takes a second to compile.

namespace toile {

using Json = OrderedJson;  // fields in the order of docs/report.md

/// Writes a number as JSON, which has no NaN and no infinity: null instead.
Json number(double value);
Json number(const std::optional<double>& value);
Json text(std::string_view words);
/// A problem for programs and people: its code, which never changes, its sentence, and the places
/// in it.
Json errorJson(const Error& error);
/// Adds `places` to a sentence that names any.
void addPlaces(Json& json, const std::vector<PlaceInText>& places);
/// Adds `changed_by` if there are changes.
void addChanges(Json& json, const std::vector<LengthChange>& changes);
/// The text, or null if it is empty.
Json textOrNull(const std::string& words);

/// @param results  one per piece, or empty if nothing is flat yet
Json filesJson(const Garment& garment, const PieceResults& results);
Json cutsJson(const Garment& garment);
Json seamsJson(const Garment& garment, const PieceResults& results);
/// The quality of a drawn outline. Precondition: the result has one (`FlatPiece::line`).
Json lineJson(const PieceResult& result);
/// Adds allowances and notches, if there are any.
void addPatternJson(Json& json, const Pattern& pattern, const PatternPiece& piece);
/// Pieces that are cut a second time. @param pattern  as cut (`asCut`)
Json facingsJson(const Pattern& pattern);
/// Kinks at the ends of seams, exact and as drawn. @param results  one per piece
Json seamEndsJson(const Garment& garment, const PieceResults& results);
/// The plane, the mirrored pairs, and the changes by common lengths and mirrored lines.
/// @param results  one per piece
Json symmetryJson(const Garment& garment, const PieceResults& results, const Symmetry& symmetry);
/// All problems of the garment except those of its files.
Json problemsJson(const Garment& garment);

struct SourceFile;

/// All problems of a file as a whole, each once: of reading, unit and triangulating, in this order.
Problems problemsOf(const SourceFile& file);

/// Whether a mesh written from the file must differ from it because of this problem.
bool changesOutput(ErrorCode code);

}  // namespace toile
