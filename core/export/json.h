// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/json_fields.h"
#include "core/base/place_words.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/pattern.h"
#include "core/seam/seam_measure.h"
#include "core/symmetry/symmetry.h"

/// The parts that the report and the description of a garment share. Include in writers only: the
/// JSON library takes a second to compile.

namespace toile {

using Json = OrderedJson;  // fields in the order of docs/report.md

/// The one way of a number into a file: JSON has no NaN and no infinity.
Json number(double value);
Json number(const std::optional<double>& value);
Json text(std::string_view words);
/// A fault as programs and people read it: its code, which never changes, its sentence, and the
/// places that this tells.
Json errorJson(const Error& error);
/// Adds `places` beside a sentence, where it tells any.
void addPlaces(Json& json, const std::vector<ToldPlace>& places);
/// Adds `changed_by`, where anything is changed.
void addChanges(Json& json, const std::vector<LengthChange>& changes);
/// The text, or null where there is none.
Json textOrNull(const std::string& words);

/// @param results  one per piece, or empty where nothing is flat yet
Json filesJson(const Garment& garment, const PieceResults& results);
Json cutsJson(const Garment& garment);
Json seamsJson(const Garment& garment, const PieceResults& results);
/// How a drawn outline came out. Precondition: the result has one (`FlatPiece::line`).
Json lineJson(const PieceResult& result);
/// Adds what has been added to the outline: allowances and notches, where there are any.
void addPatternJson(Json& json, const Pattern& pattern, const PatternPiece& piece);
/// What is cut a second time. @param pattern  as it is cut (`asCut`)
Json facingsJson(const Pattern& pattern);
/// Kinks at the ends of seams, exact and as drawn. @param results  one per piece
Json seamEndsJson(const Garment& garment, const PieceResults& results);
/// The plane, what mirrors what, and what common lengths and mirrored lines change.
/// @param results  one per piece
Json symmetryJson(const Garment& garment, const PieceResults& results, const Symmetry& symmetry);
/// What there is to say about the garment beyond its files.
Json problemsJson(const Garment& garment);

struct SourceFile;

/// Everything there is to say about a file as a whole, each problem once: what reading, unit and
/// triangulating had to say, in this order.
Problems problemsOf(const SourceFile& file);

/// True where a mesh written from the file cannot equal it because of this problem.
bool changesOutput(ErrorCode code);

}  // namespace toile
