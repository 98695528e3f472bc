// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/cli/typed_options.h"

namespace CLI {  // NOLINT(readability-identifier-naming): its own
class App;
}  // namespace CLI

namespace toile::app {

/// How a picture of both views shows them. @param overlay  the help of what is painted on the cloth
void addPicture(CLI::App& command, TypedOptions& typed, Arguments& arguments,
                const std::string& overlay);
/// What a picture of the garment as designed has beside these.
void addRenderedPicture(CLI::App& command, PictureArguments& picture);

/// Of a proof: what is typed of a picture that is not asked for. Empty: nothing is.
std::string wrongWithoutPicture(const CLI::App& app, const Arguments& arguments);

}  // namespace toile::app
