// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace toile::io {

/// Values by name, as the file's text: strings without their quotes, others with their brackets.
using UsdValues = std::map<std::string, std::string, std::less<>>;

/// A prim of a USD file: its name, its attributes, and the prims in it.
struct UsdPrim {
    std::string specifier{};  ///< "def", "over" or "class"
    std::string type{}, name{};
    UsdValues attributes{};
    UsdValues metadata{};  ///< of the attributes that have any, by the same names
    std::vector<UsdPrim> children{};

    /// Null if there is none.
    const std::string* find(std::string_view attribute) const;
    const UsdPrim* child(std::string_view called) const;
};

struct UsdStage {
    UsdValues metadata{};  ///< metersPerUnit, upAxis ...
    std::vector<UsdPrim> prims{};
};

/// Parses USD text, ignoring what other files, variants and references add. Values are not
/// interpreted. Errors: MalformedFile with the line, also for excessive nesting.
/// Cost: linear; all values are copied. Pure.
Result<UsdStage> parseUsd(std::string_view bytes);

/// All numbers of a value, whatever separates them; nothing if one is out of range or the value is
/// null.
std::optional<std::vector<double>> usdNumbers(const std::string* value);

/// The numbers of an attribute; for an animated one, at its first time.
std::optional<std::vector<double>> usdNumbersOf(const UsdPrim& prim, const std::string& attribute);

/// The strings of a list: ["a", "b"].
std::vector<std::string> usdStrings(std::string_view list);

}  // namespace toile::io
