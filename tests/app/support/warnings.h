// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace toile::test {

using namespace app;

/// Collects what Qt warns of while it lives; one at a time. What the platform says of itself (the
/// display, its fonts, the driver) does not count.
class Warnings {
public:
    Warnings();
    ~Warnings();

    const QStringList& texts() const;
};

}  // namespace toile::test
