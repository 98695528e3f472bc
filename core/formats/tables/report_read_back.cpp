// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/json_fields.h"
#include "core/base/text.h"
#include "core/formats/read_back.h"
#include "core/formats/writers.h"
#include "core/seam/seam_measure.h"

namespace toile {
namespace {

/// The difference between a field and a length, mm; none if only one is missing, or they differ by
/// more than the tolerance.
std::optional<double> lengthDifference(const JsonDocument& json, const char* field,
                                       const std::optional<double>& length) {
    const auto found = json.is_object() ? json.find(field) : json.end();
    if (!json.is_object() || found == json.end() || found->is_number() != length.has_value()) {
        return {};
    }
    const double difference = length ? std::abs(found->get<double>() - *length) : 0;
    return difference <= kReadBackLengths ? std::optional(difference) : std::nullopt;
}

const JsonDocument* listOf(const JsonDocument& report, const char* key, std::size_t count) {
    const auto found = report.is_object() ? report.find(key) : report.end();
    const bool isThere =
        report.is_object() && found != report.end() && found->is_array() && found->size() == count;
    return isThere ? &*found : nullptr;
}

}  // namespace

Result<ReadBack> readBackReport(const std::string& bytes, const Garment& garment,
                                const PieceResults& results) {
    const auto report = parseJson(bytes, "", ErrorCode::NotReadBack);
    if (!report) {
        return report.error();
    }
    const JsonDocument* const pieces = listOf(*report, "pieces", results.size());
    const JsonDocument* const seams = listOf(*report, "seams", garment.seams.seams.size());
    if (!pieces || !seams) {
        return notReadBack("report", "pieces or seams are missing");
    }
    ReadBack found;
    for (std::size_t k = 0; k < results.size(); ++k) {
        const auto& quality = results[k]->quality;
        const auto perimeter = quality ? std::optional(quality->perimeter2d) : std::nullopt;
        const auto difference = lengthDifference((*pieces)[k], "perimeter_2d", perimeter);
        if (!difference) {
            return notReadBack(garment.pieces[k]->name, "perimeter_2d");
        }
        found.pieces += quality ? 1 : 0;
        found.largest = std::max(found.largest, *difference);
    }
    for (std::size_t k = 0; k < garment.seams.seams.size(); ++k) {
        const Seam& seam = garment.seams.seams[k];
        for (const auto& [side, field] :
             {std::pair(&seam.left, "length_2d_left"), std::pair(&seam.right, "length_2d_right")}) {
            const bool isFlat =
                side->piece >= 0 && results[static_cast<std::size_t>(side->piece)]->flat;
            const auto length =
                isFlat ? std::optional(flatLength(
                             *side, *garment.pieces[static_cast<std::size_t>(side->piece)],
                             *results[static_cast<std::size_t>(side->piece)]->flat))
                       : std::nullopt;
            const auto difference = lengthDifference((*seams)[k], field, length);
            if (!difference) {
                return notReadBack(seam.name, field);
            }
            found.seams += isFlat ? 1 : 0;
            found.largest = std::max(found.largest, *difference);
        }
    }
    return found;
}

}  // namespace toile
