// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractNativeEventFilter>

namespace toile::test {

using namespace app;

/// While it exists, the program under test receives pointer, keyboard and focus events only from
/// the test. It ignores the position of the display's own pointer and other input on a desktop. The
/// test sets the active window itself: QApplication::setActiveWindow. It filters X11 events only.
/// Precondition: an application exists.
class OwnInput : public QAbstractNativeEventFilter {
public:
    OwnInput();

    bool nativeEventFilter(const QByteArray& kind, void* message, qintptr* result) override;
};

}  // namespace toile::test
