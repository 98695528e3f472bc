// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "app/cli/refusal.h"
#include "core/base/json_fields.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile::app {

struct BatchEntry;

/// How a garment came out, for docs/batch.md.
inline constexpr const char* kBatchDone = "done";  ///< every piece, every file
inline constexpr const char* kBatchSomeFailed =
    "some-failed";  ///< pieces failed, or cloth cut by the pattern would be wasted (`hasFaults`)
inline constexpr const char* kBatchFailed = "failed";  ///< there is nothing

/// What a garment took of the machine: all of a record that is another at every run.
struct BatchCost {
    double wallSeconds = 0, processorSeconds = 0, peakMib = 0;
};

/// The figures of a garment of which there is nothing.
OrderedJson failedFigures(const Refusal& why);
/// Those of one that has been flattened; the first piece that failed is its error. Status done or
/// some-failed; no outputs yet.
/// @param fabrics  as `findDoubts` takes them
OrderedJson figuresOf(const Garment& garment, const PieceResults& results,
                      const std::vector<Fabric>& fabrics);

/// The whole record, one line with its end.
std::string recordLine(const BatchEntry& entry, const OrderedJson& figures, const BatchCost& cost);
/// The record of a garment of the same content that another line of the list named.
std::string recordLineOf(std::string_view input, std::string_view line);

/// What of a record one asks for; empty where it is none.
struct RecordHead {
    std::string key, status, code, message;
    bool isWorthAnotherTry = false;
    std::vector<std::string> outputs;
};
RecordHead headOf(std::string_view line);

}  // namespace toile::app
