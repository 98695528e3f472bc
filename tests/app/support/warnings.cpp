// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/warnings.h"

#include <QMutex>
#include <QtGlobal>

namespace toile::test {

using namespace app;

namespace {

QMutex guard;
QStringList collected;
QtMessageHandler handlerBefore = nullptr;

bool isOfThePlatform(const QString& text, const char* category) {
    if (category && QLatin1String(category).startsWith(QLatin1String("qt.qpa"))) {
        return true;
    }
    for (const char* known : {"XDG_RUNTIME_DIR", "propagateSizeHints", "Mesa", "libEGL", "D-Bus",
                              "QStandardPaths", "This plugin supports grabbing the mouse"}) {
        if (text.contains(QLatin1String(known))) {
            return true;
        }
    }
    return false;
}

void collect(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if ((type == QtWarningMsg || type == QtCriticalMsg) &&
        !isOfThePlatform(text, context.category)) {
        const QMutexLocker lock(&guard);
        collected << text;
    }
    if (handlerBefore) {
        handlerBefore(type, context, text);
    }
}

}  // namespace

Warnings::Warnings() {
    collected.clear();
    handlerBefore = qInstallMessageHandler(collect);
}

Warnings::~Warnings() {
    qInstallMessageHandler(handlerBefore);
}

const QStringList& Warnings::texts() const {
    return collected;
}

}  // namespace toile::test
