// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/records.h"

#include "core/base/wording.h"

namespace toile {
namespace {

constexpr Word<SplitMode> kModes[] = {
    {SplitMode::Auto, "auto"},           {SplitMode::Components, "components"},
    {SplitMode::Objects, "objects"},     {SplitMode::Groups, "groups"},
    {SplitMode::Materials, "materials"}, {SplitMode::Uv, "uv"},
    {SplitMode::Seams, "seams"}};

}  // namespace

std::string_view name(SplitMode mode) {
    return wordOf(kModes, mode);
}

std::optional<SplitMode> parseSplitMode(std::string_view text) {
    return parseWord(kModes, text);
}

}  // namespace toile
