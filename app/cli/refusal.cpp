// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/refusal.h"

#include <algorithm>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/typed_words.h"
#include "core/formats/json.h"

namespace toile::app {

Refusal::Refusal(std::string what, std::string says, std::string about)
    : code(std::move(what)), message(std::move(says)), subject(std::move(about)) {}

Refusal::Refusal(const Error& error)
    : Refusal(std::string(name(error.code)), sentence(error), error.subject.name) {
    places = placesIn(error);
}

Refusal::Refusal(const Arguments& arguments)
    : Refusal(arguments.error ? Refusal(*arguments.error)
                              : Refusal(kWrongUsage, withoutSpeaker(arguments.message))) {}

bool Refusal::isWorthAnotherTry() const {
    const std::string_view transient[] = {kTimedOut,
                                          kCrashed,
                                          kKilled,
                                          kTooManyRequests,
                                          name(ErrorCode::OutOfMemory),
                                          name(ErrorCode::FileUnreadable),
                                          name(ErrorCode::FileUnwritable),
                                          name(ErrorCode::Cancelled)};
    return std::ranges::find(transient, code) != std::end(transient);
}

Json refusalJson(const Refusal& refusal) {
    Json json{{"code", refusal.code},
              {"subject", textOrNull(refusal.subject)},
              {"message", refusal.message},
              {"again", refusal.isWorthAnotherTry()}};
    addPlaces(json, refusal.places);
    return json;
}

}  // namespace toile::app
