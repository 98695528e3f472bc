// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/export/pattern_file_writer.h"

#include "core/export/json.h"
#include "core/geometry/polygon.h"

namespace toile {
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

}  // namespace toile
