// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace toile::test {

using namespace app;

/// Collects Qt's warnings while it exists; there must be only one. Ignores messages of the platform
/// (display, fonts, driver).
class Warnings {
public:
    Warnings();
    ~Warnings();

    const QStringList& texts() const;
};

}  // namespace toile::test
