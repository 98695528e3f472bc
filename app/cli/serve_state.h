// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "app/cli/arguments.h"
#include "app/cli/serve_query.h"
#include "app/cli/serve_session.h"
#include "core/formats/export_file.h"
#include "core/toile/garment_flattener.h"

namespace toile::app {

/// What a session keeps, and one function for each thing it can be asked. Refused, they leave it as
/// it was.
struct ServeSession::State {
    /// What was said of a garment: by it everything follows.
    struct Asked {
        Arguments typed{};  ///< as the words say
        std::optional<std::string> seams{};
        Arguments arguments{};  ///< with what a project says
        std::string notes{};    ///< sentences
    };

    std::optional<Asked> asked;
    GarmentInputs inputs;
    Garment made;     ///< as the inputs say
    Garment garment;  ///< with the names that a project gives
    /// As last flattened; empty before that.
    std::optional<FinishedPattern> pattern;
    GarmentFlattener flattener;

    ServeOutcome answer(const ServeRequest& request, Progress& progress);

    // serve_load.cpp
    ServeOutcome load(const ServeRequest& request, Progress& progress);
    ServeOutcome edit(const ServeRequest& request, Progress& progress);
    ServeOutcome make(Asked next, ReadFiles files, Progress& progress);

    // serve_pattern.cpp. Precondition: there is a garment.
    ServeOutcome flatten(bool settle, Progress& progress);
    ServeOutcome write(const ServeRequest& request, Progress& progress);
    ServeOutcome prove(const ServeRequest& request, Progress& progress);
    /// The pattern of this moment; a request stores it once it has succeeded.
    std::variant<FinishedPattern, Refusal> flat(bool settle, Progress& progress);
    /// Words that are said of the garment there is; a Message where they are refused.
    Arguments typedOfGarment(const char* command, const ServeRequest& request,
                             unsigned taken) const;
};

}  // namespace toile::app
