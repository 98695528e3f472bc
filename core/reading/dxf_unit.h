// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/reading/dxf_document.h"
#include "core/reading/pattern_file.h"

namespace toile {

/// The unit of a DXF pattern and its source. By the standard "Units: METRIC" means millimetres and
/// ENGLISH inches, but files in centimetres say METRIC too, and $INSUNITS is often wrong. So the
/// stated unit is used only if it gives the largest piece a plausible size; otherwise the size
/// decides. `reason` names any doubt.
struct DxfUnit {
    LengthUnit unit = LengthUnit::Millimetre;
    Wording reason{};
    bool inDoubt = false;
};

/// The unit that $INSUNITS names; none if it is missing or unknown.
std::optional<LengthUnit> headerUnit(const DxfDocument& document);

/// @param units   the value of the text "Units"; empty if missing
/// @param extent  of the largest piece, in the file's unit; 0 if unknown
DxfUnit dxfUnit(const DxfDocument& document, const std::string& units, double extent);

}  // namespace toile
