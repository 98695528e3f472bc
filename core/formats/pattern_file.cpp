// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/pattern_file.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/formats/json.h"
#include "core/geometry/polygon.h"

namespace toile {

std::vector<int> sampleOf(const PatternFile& file) {
    const bool hasSample = std::ranges::find(file.sizes, file.sampleSize) != file.sizes.end();
    const std::string size = hasSample            ? file.sampleSize
                             : file.sizes.empty() ? std::string()
                                                  : file.sizes.front();
    std::vector<int> found;
    for (int k = 0; k < static_cast<int>(file.pieces.size()); ++k) {
        const std::string& own = file.pieces[static_cast<std::size_t>(k)].size;
        if (own.empty() || own == size) {
            found.push_back(k);
        }
    }
    return found;
}

namespace {

Json perimeterJson(const Points2& line) {
    return line.rows() == 0 ? Json() : number(geometry::perimeterOf(line));
}

Json pieceJson(const FilePiece& piece) {
    Json json;
    json["id"] = piece.id;
    json["name"] = piece.name;
    json["size"] = textOrNull(piece.size);
    json["quantity"] = piece.quantity;
    json["mirrored_quantity"] = piece.mirroredQuantity;
    json["material"] = textOrNull(piece.material);
    json["cut_length"] = perimeterJson(piece.cut);
    json["seam_length"] = perimeterJson(piece.sew);
    json["area"] = number(geometry::signedAreaOf(outlineOf(piece)));
    json["points"] = outlineOf(piece).rows();
    json["holes"] = piece.holes.size();
    json["internal_lines"] = piece.internals.size();
    json["notches"] = piece.notches.size();
    json["drills"] = piece.drills.size();
    json["unfolded"] = piece.isUnfolded;
    json["has_grain"] = piece.grain.has_value();
    json["layers"] = Json::object();
    for (const auto& [layer, count] : piece.layers) {
        json["layers"][layer] = count;
    }
    return json;
}

}  // namespace

std::string writePatternFile(const PatternFile& file) {
    Json json;
    json["format"] = text(file.format);
    json["unit"] = text(unitText(file.unit));
    json["unit_reason"] = textOrNull(file.unitReason);
    json["unit_in_doubt"] = file.unitInDoubt;
    json["style"] = textOrNull(file.style);
    json["sample_size"] = textOrNull(file.sampleSize);
    json["sizes"] = Json(file.sizes);
    json["pieces"] = Json::array();
    for (const FilePiece& piece : file.pieces) {
        json["pieces"].push_back(pieceJson(piece));
    }
    json["notes"] = Json::array();
    for (const Wording& note : file.notes) {
        json["notes"].push_back(note);
    }
    return jsonText(json);
}

void shortenNotes(std::vector<Wording>& notes) {
    constexpr long long kMaxOfKind = 10;
    std::map<const char*, long long> counts, seen;
    for (const Wording& note : notes) {
        ++counts[note.pattern()];
    }
    std::vector<Wording> kept;
    for (Wording& note : notes) {
        const long long number = ++seen[note.pattern()], more = counts[note.pattern()] - kMaxOfKind;
        if (number <= kMaxOfKind || more == 1) {
            kept.push_back(std::move(note));
        } else if (number == kMaxOfKind + 1) {
            kept.push_back(worded("%1 more notes like: %2", {std::to_string(more), note}));
        }
    }
    notes = std::move(kept);
}

}  // namespace toile
