// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

#include "app/widgets/garment_card.h"

namespace toile::app {

class Document;
class Workspace;

/// What was assumed about the garment's files, in a person's words.

/// "height 1.23 m · cm (guessed) · 13 pieces by UV islands"; "(from the file)" if the file states
/// its unit, nothing if a person does. Empty if nothing is open.
QString garmentSummary(const Document& document);
/// Why: unit, up axis and division of every file, a line each.
QString garmentReasons(const Document& document);
enum class Asked { WhereInDoubt, Always };
/// What to ask the person: the unit and the up axis of the first file where they are in doubt, or
/// of the first file; what a file is that is no plain sheet; and whether to divide otherwise, where
/// more pieces could lie flat then. Answers are the workspace's, which must outlive them.
/// @param prepareScan  asks for the steps that make a sheet of a scan
GarmentQuestions garmentQuestions(Workspace& workspace, const std::function<void()>& prepareScan,
                                  Asked asked = Asked::WhereInDoubt);

}  // namespace toile::app
