// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/refusal.h"
#include "core/base/json_fields.h"
#include "core/base/progress.h"

namespace toile::app {

// The parts of `toile serve`: requests, answers, and the garment they refer to.

/// A parsed request. Missing fields are empty.
struct ServeRequest {
    std::string id = "null";          ///< as JSON; null if it could not be read
    std::string what{};               ///< "load", one of `kServeWords`
    std::vector<std::string> args{};  ///< words of the command line
    bool hasArgs = false;
    std::optional<std::string> seams{};  ///< the text of a seams file
    bool settle = false;
    std::vector<std::string> wanted{}, pieces{};
    std::string of = "null";           ///< the id of another request
    std::optional<Refusal> refusal{};  ///< why it is invalid; then only the id is set
};

/// All requests, in the order of docs/serve.md.
inline constexpr std::string_view kServeWords[] = {"load",  "edit",   "flatten", "query", "export",
                                                   "prove", "cancel", "close",   "quit"};

/// Maximum bytes of a line; a longer one is refused.
inline constexpr std::size_t kMaxServeLine = std::size_t{16} << 20U;
inline constexpr std::size_t kMaxServeId = 100;  ///< bytes of a textual id

/// Never fails: an invalid line yields a refusal. Linear.
ServeRequest readServeRequest(std::string_view line);
/// The request for a line longer than kMaxServeLine.
ServeRequest tooLongServeRequest();

/// Answers as lines with line breaks. @param id  as JSON
std::string serveAnswer(const std::string& id, const OrderedJson& result);
std::string serveAnswer(const std::string& id, const Refusal& refusal);
std::string serveProgress(const std::string& id, double fraction);

/// The garment of `toile serve`; answers one request at a time. Prints nothing and starts no thread
/// itself. Not thread-safe.
class ServeSession {
public:
    ServeSession();
    ~ServeSession();
    ServeSession(const ServeSession&) = delete;
    ServeSession& operator=(const ServeSession&) = delete;

    /// Executes a request. @return the answer as a line. Never throws. A failed or cancelled
    /// request leaves the garment unchanged. `cancel` and `quit` do nothing here.
    /// Cost: that of the command of the same name.
    std::string answer(const ServeRequest& request, Progress& progress);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace toile::app
