// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cut/cut_error.h"

#include <utility>

namespace toile {

Error cutError(std::string where, Wording detail) {
    return {ErrorCode::CutImpossible, std::move(where), std::move(detail)};
}

}  // namespace toile
