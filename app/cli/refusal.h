// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <iosfwd>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/base/error.h"
#include "core/base/result.h"
#include "core/base/wording.h"

namespace toile::app {

/// Exit status of the program; `exitMeanings` explains them.
enum ExitStatus { kExitDone = 0, kExitSomeFailed = 1, kExitUsage = 2, kExitUnreadable = 3 };

struct ExitMeaning {
    const char* status;   ///< a number, or "128 + N"
    const char* meaning;  ///< without a full stop
};

/// Each status once, ascending, for the help, the manual page and docs/report.md.
std::span<const ExitMeaning> exitMeanings();

/// Codes in addition to those of `ErrorCode`; docs/batch.md and docs/serve.md explain them.
inline constexpr const char* kWrongUsage = "wrong-usage";
inline constexpr const char* kNotFlat = "not-flat";
inline constexpr const char* kNotProved = "not-proved";
inline constexpr const char* kTimedOut = "timed-out";
inline constexpr const char* kCrashed = "crashed";
inline constexpr const char* kKilled = "killed";
inline constexpr const char* kTooManyRequests = "too-many-requests";

/// Why a request failed: printed by commands, sent by `toile serve`, recorded by `toile batch`,
/// raised in Python.
struct Refusal {
    std::string code;
    std::string message;                ///< a sentence that suggests a remedy
    std::string subject;                ///< the file, piece, seam or cut; empty: everything
    std::vector<PlaceInText> places{};  ///< the places mentioned in the message
    std::string
        help{};  ///< the command whose --help explains the usage, for terminals: "toile info"

    Refusal(std::string what, std::string says, std::string about = {});
    Refusal(const Error& error);

    /// Whether a retry may help: the machine caused the failure, not the request.
    bool isRetryable() const;
};

Refusal usageRefusal(std::string message);

/// JSON with code, subject (null: everything), message, again, and places if there are any.
nlohmann::ordered_json refusalJson(const Refusal& refusal);

/// A value, or why it was refused. Accessing the wrong one is a bug (asserted).
template <class T>
class [[nodiscard]] Answer {
public:
    Answer(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Answer(Refusal refusal) : state_(std::in_place_index<1>, std::move(refusal)) {}
    Answer(const Error& error) : Answer(Refusal(error)) {}

    explicit operator bool() const { return state_.index() == 0; }
    T& operator*() & { return assert(*this), *std::get_if<0>(&state_); }
    const T& operator*() const& { return assert(*this), *std::get_if<0>(&state_); }
    T&& operator*() && { return assert(*this), std::move(*std::get_if<0>(&state_)); }
    T* operator->() { return &**this; }
    const T* operator->() const { return &**this; }
    const Refusal& refusal() const { return assert(!*this), *std::get_if<1>(&state_); }

private:
    std::variant<T, Refusal> state_;
};

/// Messages for the user. They are stored, and printed as lines "toile: ..." if there is a stream.
class Messages {
public:
    Messages() = default;
    explicit Messages(std::ostream& err) : err_(&err) {}

    void add(const std::string& sentence);
    void add(const Error& error) { add(sentence(error)); }
    /// For lines that are not messages. Precondition: it has a stream.
    std::ostream& stream() const { return *err_; }

    const std::vector<std::string>& sentences() const { return sentences_; }

private:
    std::ostream* err_ = nullptr;
    std::vector<std::string> sentences_;
};

/// Reports the refusal. @return the exit status: wrong usage, or kExitUnreadable
int refuse(const Refusal& refusal, Messages& messages);

}  // namespace toile::app
