// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace toile::io {

/// Values by name, as the file's text: strings without their quotes, all else with its brackets.
using UsdValues = std::map<std::string, std::string, std::less<>>;

/// A prim of a USD file: what it is called, its attributes, and the prims in it.
struct UsdPrim {
    std::string specifier{};  ///< "def", "over" or "class"
    std::string type{}, name{};
    UsdValues attributes{};
    UsdValues metadata{};  ///< of the attributes that have any, by the same names
    std::vector<UsdPrim> children{};

    /// Null where there is none.
    const std::string* find(std::string_view attribute) const;
    const UsdPrim* child(std::string_view called) const;
};

struct UsdStage {
    UsdValues metadata{};  ///< metersPerUnit, upAxis ...
    std::vector<UsdPrim> prims{};
};

/// USD as text, without what other files, variants and references add to it. Values are not looked
/// at. Errors: MalformedFile with the line, also for prims that lie deeper than in any scene.
/// Cost: linear; all values are copied. Pure.
Result<UsdStage> parseUsd(std::string_view bytes);

/// All numbers of a value, whatever stands between them; none where one is out of all bounds or the
/// value is null.
std::optional<std::vector<double>> usdNumbers(const std::string* value);

/// Those of an attribute; of one that moves, at the first moment it has.
std::optional<std::vector<double>> usdNumbersOf(const UsdPrim& prim, const std::string& attribute);

/// The strings of a list of them: ["a", "b"].
std::vector<std::string> usdStrings(std::string_view list);

}  // namespace toile::io
