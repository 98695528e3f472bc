// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/serve_session.h"

#include <exception>
#include <new>

#include "app/cli/serve_state.h"

namespace toile::app {

ServeOutcome ServeSession::State::answer(const ServeRequest& request, Progress& progress) {
    if (request.refusal) {
        return *request.refusal;
    }
    if (progress.isCancelled()) {
        return Refusal(Error{ErrorCode::Cancelled});
    }
    const std::string& what = request.what;
    if (what == "load") {
        return load(request, progress);
    }
    if (what == "cancel" || what == "quit") {
        return OrderedJson::object();
    }
    if (!asked) {
        return Refusal("no-garment", "there is no garment; send \"load\" first");
    }
    if (what == "edit") {
        return edit(request, progress);
    }
    if (what == "flatten") {
        return flatten(request.settle, progress);
    }
    if (what == "query") {
        return serveQuery(request, garment, pattern ? pattern->results : PieceResults(),
                          pattern ? &pattern->laid : nullptr);
    }
    if (what == "export") {
        return write(request, progress);
    }
    if (what == "prove") {
        return prove(request, progress);
    }
    asked.reset();  // close
    inputs = {};
    made = garment = {};
    pattern.reset();
    flattener.reset();
    return OrderedJson::object();
}

ServeSession::ServeSession() : state_(std::make_unique<State>()) {}
ServeSession::~ServeSession() = default;

std::string ServeSession::answer(const ServeRequest& request, Progress& progress) {
    try {
        const ServeOutcome outcome = state_->answer(request, progress);
        const auto* refusal = std::get_if<Refusal>(&outcome);
        return refusal ? serveAnswer(request.id, *refusal)
                       : serveAnswer(request.id, std::get<OrderedJson>(outcome));
    } catch (const std::bad_alloc&) {
        return serveAnswer(request.id, Refusal(Error{ErrorCode::OutOfMemory}));
    } catch (const std::exception& fault) {  // a bug: still an answer
        return serveAnswer(request.id, Refusal("unexpected", fault.what()));
    }
}

}  // namespace toile::app
