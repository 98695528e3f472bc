// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractNativeEventFilter>

namespace toile::test {

using namespace app;

/// While it lives, a program under test hears of no pointer, keyboard and focus but those that the
/// test sends it: not of where the display's own pointer happens to rest, and on a desktop not of
/// what somebody does there meanwhile.
/// Which of its own windows is active, the test says: QApplication::setActiveWindow.
/// Of other platforms than X11 nothing is held back. An application must be there.
class OwnInput : public QAbstractNativeEventFilter {
public:
    OwnInput();

    bool nativeEventFilter(const QByteArray& kind, void* message, qintptr* result) override;
};

}  // namespace toile::test
