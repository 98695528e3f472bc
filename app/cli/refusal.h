// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/base/error.h"
#include "core/base/wording.h"

namespace toile::app {

struct Arguments;

/// Codes beside those of `ErrorCode`; docs/batch.md and docs/serve.md say what they mean.
inline constexpr const char* kWrongUsage = "wrong-usage";
inline constexpr const char* kNotFlat = "not-flat";
inline constexpr const char* kNotProved = "not-proved";
inline constexpr const char* kTimedOut = "timed-out";
inline constexpr const char* kCrashed = "crashed";
inline constexpr const char* kKilled = "killed";
inline constexpr const char* kTooManyRequests = "too-many-requests";

/// Why something is not done, as other programs are told: in answers of `toile serve`, in records
/// of `toile batch`, as an exception of Python.
struct Refusal {
    std::string code;
    std::string message;  ///< a sentence that says what may help
    std::string subject;  ///< the file, piece, seam or cut that it is about; empty: everything
    std::vector<PlaceInText> places{};  ///< that the message tells

    Refusal(std::string what, std::string says, std::string about = {});
    Refusal(const Error& error);
    /// Precondition: the arguments are a Message.
    explicit Refusal(const Arguments& arguments);

    /// Whether trying again may help: the machine was the reason, not what was asked for.
    bool isWorthAnotherTry() const;
};

/// Its one form in JSON: code, subject (null: everything), message, again, and places where there
/// are any.
nlohmann::ordered_json refusalJson(const Refusal& refusal);

}  // namespace toile::app
