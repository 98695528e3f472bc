// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/refusal.h"

#include <algorithm>
#include <ostream>

#include "core/formats/json.h"

namespace toile::app {
namespace {

constexpr ExitMeaning kExitMeanings[] = {
    {"0", "fine, or doubts only"},
    {"1",
     "cloth would be cut wrong, and all files are written: a piece failed or has no usable cut, "
     "its outline crosses itself, triangles are flipped, or, where no fabric is chosen, its mean "
     "strain is above 6 % or 5 % of its area is strained by more than 25 %; check or prove found "
     "faults, prove could not settle, walk unequal lengths, compare a piece without a partner, "
     "marker a piece without "
     "room; or with --fail-on doubt there is a doubt"},
    {"2", "wrong usage"},
    {"3", "a file cannot be read or written, memory did not suffice, or the window has no display"},
    {"128 + N", "batch was ended by signal N: 130 after Ctrl-C, 143 after SIGTERM"},
};

}  // namespace

std::span<const ExitMeaning> exitMeanings() {
    return kExitMeanings;
}

Refusal::Refusal(std::string what, std::string says, std::string about)
    : code(std::move(what)), message(std::move(says)), subject(std::move(about)) {}

Refusal::Refusal(const Error& error)
    : Refusal(std::string(name(error.code)), sentence(error), error.subject.name) {
    places = placesIn(error);
}

bool Refusal::isRetryable() const {
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

Refusal usageRefusal(std::string message) {
    return {kWrongUsage, std::move(message)};
}

Json refusalJson(const Refusal& refusal) {
    Json json{{"code", refusal.code},
              {"subject", textOrNull(refusal.subject)},
              {"message", refusal.message},
              {"again", refusal.isRetryable()}};
    addPlaces(json, refusal.places);
    return json;
}

void Messages::add(const std::string& sentence) {
    sentences_.push_back(sentence);
    if (err_ != nullptr) {
        *err_ << "toile: " << sentence << '\n';
    }
}

int refuse(const Refusal& refusal, Messages& messages) {
    messages.add(refusal.help.empty() ? refusal.message
                                      : refusal.message + "; see " + refusal.help + " --help.");
    return refusal.code == kWrongUsage ? kExitUsage : kExitUnreadable;
}

}  // namespace toile::app
