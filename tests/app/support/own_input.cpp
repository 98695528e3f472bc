// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/own_input.h"

#include <QCoreApplication>
#include <cstdint>

namespace toile::test {

using namespace app;

namespace {

// Of the X protocol, section 11; its headers are not asked for here.
constexpr int kFirstOfInput = 2;   ///< KeyPress, KeyRelease, ButtonPress, ButtonRelease,
                                   ///< MotionNotify, EnterNotify, LeaveNotify, FocusIn
constexpr int kLastOfInput = 10;   ///< FocusOut
constexpr int kOfExtensions = 35;  ///< GenericEvent: those of the input extension
constexpr int kSent = 0x80;        ///< set where another program has sent it

}  // namespace

OwnInput::OwnInput() {
    QCoreApplication::instance()->installNativeEventFilter(this);
}

bool OwnInput::nativeEventFilter(const QByteArray& kind, void* message, qintptr*) {
    if (kind != "xcb_generic_event_t") {
        return false;
    }
    const int type = *static_cast<const std::uint8_t*>(message) & ~kSent;
    return (type >= kFirstOfInput && type <= kLastOfInput) || type == kOfExtensions;
}

}  // namespace toile::test
