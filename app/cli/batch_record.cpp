// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch_record.h"

#include <algorithm>
#include <cmath>

#include "app/cli/batch_list.h"
#include "core/base/id.h"
#include "core/base/version.h"
#include "core/diagnose/doubt.h"
#include "core/formats/json.h"
#include "core/formats/tables/report_tables.h"
#include "core/seam/seam_measure.h"

namespace toile::app {
namespace {

/// Every field, in its order, with nothing in it.
OrderedJson noFigures(const char* status) {
    OrderedJson figures;
    figures["status"] = status;
    for (const char* field :
         {"error", "pieces", "failed_pieces", "triangles", "seams", "worst_seam_mm", "strain_mean",
          "strain_max", "flipped", "crossings", "fingerprint"}) {
        figures[field] = nullptr;
    }
    for (const char* list : {"doubts", "notes", "outputs"}) {
        figures[list] = OrderedJson::array();
    }
    return figures;
}

/// Mean and largest strain, parts of 1, and what lies wrong; the mean weighted by area.
void addStrain(OrderedJson& figures, const PieceResults& results) {
    double area = 0, strain = 0, most = 0;
    int flipped = 0, crossings = 0;
    for (const auto& result : results) {
        if (!result->quality) {
            continue;
        }
        const PieceQuality& quality = *result->quality;
        area += quality.area3d;
        strain += quality.area3d * quality.strainMeanAbs.value_or(0);
        most = std::max({most, std::abs(quality.strainMin.value_or(0)),
                         std::abs(quality.strainMax.value_or(0))});
        flipped += quality.flippedTriangles;
        crossings += quality.outlineCrossings;
    }
    if (area > 0) {
        figures["strain_mean"] = number(strain / area);
        figures["strain_max"] = number(most);
        figures["flipped"] = flipped;
        figures["crossings"] = crossings;
    }
}

/// Of all flat points, so that two runs are seen to be the same without their files.
std::string fingerprintOf(const PieceResults& results) {
    std::string each;
    for (const auto& result : results) {
        each += hashText(result->fingerprint);
    }
    return hashText(contentHash(each));
}

}  // namespace

OrderedJson failedFigures(const Refusal& why) {
    OrderedJson figures = noFigures(kBatchFailed);
    figures["error"] = refusalJson(why);
    return figures;
}

OrderedJson figuresOf(const Garment& garment, const PieceResults& results,
                      const std::vector<Fabric>& fabrics) {
    OrderedJson figures = noFigures(kBatchDone);
    long long triangles = 0;
    int failed = 0;
    const auto fail = [&figures](const Refusal& why) {
        figures["status"] = kBatchSomeFailed;
        figures["error"] = figures["error"].is_null() ? refusalJson(why) : figures["error"];
    };
    for (const auto& result : results) {
        triangles += result->piece->mesh.F.rows();
        if (result->error && !isLeftOut(*result)) {
            ++failed;
            fail(*result->error);
        } else if (breaksPromise(*result)) {
            ++failed;
            fail({std::string(name(ErrorCode::TrianglesFlipped)),
                  std::string(describe(ErrorCode::TrianglesFlipped)), result->piece->name});
        }
    }
    for (const Error& problem : garment.problems) {
        if (!isNote(problem.code)) {
            fail(problem);
        }
    }
    figures["pieces"] = results.size();
    figures["failed_pieces"] = failed;
    figures["triangles"] = triangles;
    const std::vector<MeasuredSeam> seams = seamsByError(garment, results);
    figures["seams"] = seams.size();
    if (!seams.empty()) {
        figures["worst_seam_mm"] = number(std::abs(seams.front().measure.errorMm));
    }
    addStrain(figures, results);
    figures["fingerprint"] = fingerprintOf(results);
    const auto doubts = findDoubts(garment, results, fabrics);
    for (const Finding& doubt : doubts) {
        figures["doubts"].push_back(name(doubt.kind));
        if (doubt.severity == Severity::Fault) {
            fail({std::string(name(doubt.kind)), sentence(doubt), doubt.subject.name});
        }
    }
    if (hasFaults(garment, results, doubts) && figures["error"].is_null()) {
        const bool crosses = std::ranges::any_of(results, [](const auto& result) {
            return result->quality && result->quality->outlineCrossings > 0;
        });
        const ErrorCode code = crosses ? ErrorCode::OutlineCrosses : ErrorCode::TrianglesFlipped;
        fail({std::string(name(code)), std::string(describe(code))});
    }
    return figures;
}

std::string recordLine(const BatchEntry& entry, const OrderedJson& figures, const BatchCost& cost) {
    OrderedJson record;
    record["name"] = entry.name;
    record["input"] = text(entry.path);
    record["hash"] = textOrNull(entry.inputHash);
    record["options"] = OrderedJson::array();
    for (const std::string& word : entry.words) {
        record["options"].push_back(text(word));
    }
    record["toile"] = text(version());
    record["key"] = entry.key;
    record.update(figures);
    record["cost"] = {{"wall_s", number(cost.wallSeconds)},
                      {"processor_s", number(cost.processorSeconds)},
                      {"peak_mib", number(cost.peakMib)}};
    return record.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

std::string recordLineOf(std::string_view input, std::string_view line) {
    OrderedJson record = OrderedJson::parse(line, nullptr, false);
    if (!record.is_object()) {
        return std::string(line);
    }
    record["input"] = text(input);
    return record.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

RecordHead headOf(std::string_view line) {
    const OrderedJson record = OrderedJson::parse(line, nullptr, false);
    RecordHead head;
    const auto word = [](const OrderedJson& in, const char* field) {
        const auto found = in.find(field);
        return found != in.end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    if (!record.is_object() || !record.contains("error") || !record.contains("outputs")) {
        return head;
    }
    head.key = word(record, "key");
    head.status = word(record, "status");
    if (record["error"].is_object()) {
        head.code = word(record["error"], "code");
        head.message = word(record["error"], "message");
        head.isWorthAnotherTry = record["error"].value("again", OrderedJson()) == true;
    }
    for (const OrderedJson& output : record["outputs"]) {
        head.outputs.push_back(output.is_string() ? output.get<std::string>() : std::string());
    }
    return head;
}

}  // namespace toile::app
