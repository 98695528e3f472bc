// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

#include "app/widgets/garment_card.h"

namespace toile::app {

class Document;
class Workspace;

/// What Toile assumed about the garment's files, as text for the user.

/// For example "height 1.23 m · cm (guessed) · 13 pieces by UV islands". "(from the file)" if the
/// file states its unit, nothing if the user does. Empty if nothing is open.
QString garmentSummary(const Document& document);
/// The reasons for unit, up axis and division of every file, one per line.
QString garmentReasons(const Document& document);
enum class Asked { WhereInDoubt, Always };
/// Questions for the user: unit and up axis of the first file in doubt (`Always`: of the first
/// file), how to read a file that is not a plain sheet, and a division by which more pieces can lie
/// flat. The answers call `workspace`, which must outlive them.
/// @param prepareScan  asks the user how to prepare a scan
GarmentQuestions garmentQuestions(Workspace& workspace, const std::function<void()>& prepareScan,
                                  Asked asked = Asked::WhereInDoubt);

}  // namespace toile::app
