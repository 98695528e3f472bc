// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/json_fields.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"

namespace toile::app {

struct Arguments;
struct BatchEntry;

/// How a garment came out, for docs/batch.md.
inline constexpr const char* kBatchDone = "done";  ///< every piece, every file
inline constexpr const char* kBatchSomeFailed =
    "some-failed";                                     ///< pieces failed, the rest is there
inline constexpr const char* kBatchFailed = "failed";  ///< there is nothing

/// Codes beside those of `ErrorCode`.
inline constexpr const char* kTimedOut = "timed-out";
inline constexpr const char* kCrashed = "crashed";
inline constexpr const char* kKilled = "killed";

/// What a garment took of the machine: all of a record that is another at every run.
struct BatchCost {
    double wallSeconds = 0, processorSeconds = 0, peakMib = 0;
};

/// The figures of a garment of which there is nothing.
/// @param subject  what the error is about; empty: the garment
OrderedJson failedFigures(std::string_view code, std::string_view subject,
                          std::string_view message);
OrderedJson failedFigures(const Error& error);
/// Of words that are a Message.
OrderedJson refusedFigures(const Arguments& message);
/// Those of one that has been flattened; the first piece that failed is its error. Status done or
/// some-failed; no outputs yet.
OrderedJson figuresOf(const Garment& garment, const PieceResults& results);

/// The whole record, one line with its end.
std::string recordLine(const BatchEntry& entry, const OrderedJson& figures, const BatchCost& cost);
/// The record of a garment of the same content that another line of the list named.
std::string recordLineOf(std::string_view input, std::string_view line);

/// What of a record one asks for; empty where it is none.
struct RecordHead {
    std::string key, status, code, message;
    std::vector<std::string> outputs;
};
RecordHead headOf(std::string_view line);

/// Whether trying again may help: the machine was the reason, not the garment.
bool isWorthAnotherTry(std::string_view code);

}  // namespace toile::app
