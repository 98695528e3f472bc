// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/json.h"

#include <cmath>
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/assemble/seams_file.h"
#include "core/base/file.h"
#include "core/garment/garment.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

/// The reason why a piece is not flat, or will not be.
const Error* errorOf(const Garment& garment, const PieceResults& results, std::size_t index) {
    const auto& error = results.empty() ? garment.pieces[index]->defect : results[index]->error;
    return error ? &*error : nullptr;
}

Json problemJson(const Error& error, const Json& piece) {
    Json json{{"code", text(name(error.code))}, {"piece", piece}, {"message", sentence(error)}};
    addPlaces(json, placesIn(error));
    return json;
}

Json problemJson(const Error& error) {
    return problemJson(error, error.subject.pieceId() ? Json(error.subject.name) : Json(nullptr));
}

Json fileJson(const SourceFile& file, Json problems) {
    return {{"path", pathText(file.path)},
            {"unit", text(unitText(file.unit))},
            {"unit_reason", textOrNull(file.unitReason)},
            {"up", text(name(file.up))},
            {"up_reason", textOrNull(file.upReason)},
            {"read_as", text(wordOf(kFileKindWords, file.reading.kind))},
            {"read_as_reason",
             file.reading.isStated ? Json(nullptr) : textOrNull(file.reading.evidence)},
            {"triangles_left_out", file.reading.leftOut.F.rows()},
            {"split", text(name(file.split.mode))},
            {"split_reason", textOrNull(file.split.reason)},
            {"vertices", file.soup->positions.size()},
            {"faces", file.soup->faceCount()},
            {"seconds_read", number(file.readSeconds)},
            {"problems", std::move(problems)}};
}

Json seamJson(const Garment& garment, const PieceResults& results, const Seam& seam) {
    const bool sewn = seam.right.piece >= 0;
    const auto flatOf = [&results](int piece) -> const FlatPiece* {
        const bool flat = piece >= 0 && !results.empty() && results[piece]->flat;
        return flat ? &*results[piece]->flat : nullptr;
    };
    Json pieces = Json::array({garment.pieces[seam.left.piece]->name});
    if (sewn) {
        pieces.push_back(garment.pieces[seam.right.piece]->name);
    }
    const FlatPiece* left = flatOf(seam.left.piece);
    const FlatPiece* right = flatOf(seam.right.piece);
    std::optional<double> length2dLeft, length2dRight, delta, error;
    if (left) {
        length2dLeft = flatLength(seam.left, *garment.pieces[seam.left.piece], *left);
    }
    if (right) {
        length2dRight = flatLength(seam.right, *garment.pieces[seam.right.piece], *right);
    }
    const double ease = easeOf(seam);
    if (left && right) {
        delta = *length2dLeft - *length2dRight;
        error = *length2dLeft - (1 + ease) * *length2dRight;
    }
    Json json{{"name", seam.name},
              {"kind", text(name(seam.kind))},
              {"pieces", std::move(pieces)},
              {"length_3d", number(seam.length3d[0])},
              {"length_3d_right", sewn ? number(seam.length3d[1]) : Json(nullptr)},
              {"length_2d_left", number(length2dLeft)},
              {"length_2d_right", number(length2dRight)},
              {"delta_mm", number(delta)},
              {"ease", sewn ? number(ease) : Json(nullptr)},
              {"ease_stated", seam.ease.has_value()},
              {"error_mm", number(error)},
              {"stacked", seam.stacked},
              {"closed", seam.closed}};
    addChanges(json, changesOf(seam, results));
    return json;
}

}  // namespace

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json number(const std::optional<double>& value) {
    return value ? number(*value) : Json(nullptr);
}

Json text(std::string_view words) {
    return Json(std::string(words));
}

Json errorJson(const Error& error) {
    Json json{{"code", text(name(error.code))}, {"message", sentence(error)}};
    addPlaces(json, placesIn(error));
    return json;
}

void addChanges(Json& json, const std::vector<LengthChange>& changes) {
    for (const LengthChange& change : changes) {
        json["changed_by"].push_back(
            {{"cause", text(name(change.cause))}, {"mm", number(change.millimetres)}});
    }
}

void addPlaces(Json& json, const std::vector<PlaceInText>& places) {
    for (const PlaceInText& place : places) {
        json["places"].push_back({{"words", place.words}, {"at", place.at}});
    }
}

Json textOrNull(const std::string& words) {
    return words.empty() ? Json(nullptr) : Json(words);
}

Json filesJson(const Garment& garment, const PieceResults& results) {
    std::vector<Json> problems(garment.files.size(), Json::array());
    for (std::size_t f = 0; f < garment.files.size(); ++f) {
        for (const Error& error : problemsOf(*garment.files[f])) {
            problems[f].push_back(problemJson(error));
        }
    }
    for (std::size_t i = 0; i < garment.pieces.size(); ++i) {
        const Piece& piece = *garment.pieces[i];
        if (const Error* error = errorOf(garment, results, i)) {
            problems[piece.file].push_back(problemJson(*error, Json(piece.name)));
        }
    }
    Json files = Json::array();
    for (std::size_t f = 0; f < garment.files.size(); ++f) {
        files.push_back(fileJson(*garment.files[f], std::move(problems[f])));
    }
    return files;
}

Json cutsJson(const Garment& garment) {
    Json cuts = Json::array();
    for (const CutRecord& record : garment.cutRecords) {
        const SourceFile& file = *garment.files[static_cast<std::size_t>(record.whole->file)];
        for (const AppliedCut& cut : record.cuts) {
            Json points = Json::array();
            for (const Eigen::Vector3d& point : cut.points) {
                const Eigen::RowVector3d there =
                    asInFile(file.up, point.transpose()) / millimetresPer(file.unit);
                points.push_back({number(there.x()), number(there.y()), number(there.z())});
            }
            cuts.push_back({{"name", cut.name},
                            {"kind", text(name(cut.kind))},
                            {"author", cut.author == CutAuthor::User ? "user" : "automatic"},
                            {"evidence", textOrNull(cut.evidence)},
                            {"piece", cut.piece},
                            {"length", number(cut.length)},
                            {"points", std::move(points)}});
        }
    }
    return cuts;
}

Json seamsJson(const Garment& garment, const PieceResults& results) {
    Json seams = Json::array();
    for (const Seam& seam : garment.seams.seams) {
        seams.push_back(seamJson(garment, results, seam));
    }
    return seams;
}

Json problemsJson(const Garment& garment) {
    Json problems = Json::array();
    for (const Error& error : garment.problems) {
        problems.push_back(problemJson(error));
    }
    return problems;
}

Problems problemsOf(const SourceFile& file) {
    Problems all;
    std::set<std::tuple<ErrorCode, Subject::Kind, std::string_view, std::string_view>> seen;
    for (const Error& error : file.problems) {
        const auto& [kind, id, name] = error.subject;
        if (seen.emplace(error.code, kind, name, error.detail).second) {
            all.push_back(error);
        }
    }
    return all;
}

bool changesOutput(ErrorCode code) {
    switch (code) {
        case ErrorCode::OutputDiffers:
        case ErrorCode::IndexOutOfRange:       // the faces are gone
        case ErrorCode::NonFinitePosition:     // its faces are in no piece
        case ErrorCode::DegenerateFaceRecord:  // gone, or in no piece
        case ErrorCode::MalformedFile:         // unreadable parts are gone
        case ErrorCode::VerticesWelded:        // faces refer to other vertices
            return true;
        default:
            return false;
    }
}

}  // namespace toile
