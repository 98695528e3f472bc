// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace toile {

struct Error;

/// `sentence` of core/base/error.h in the person's language: what happened, where, what to try. The
/// particulars between brackets stay as the core words them.
QString errorText(const Error& error);

}  // namespace toile
