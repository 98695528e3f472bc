// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/disposal.h"

#include <QCoreApplication>
#include <QThread>
#include <QThreadPool>
#include <utility>

namespace toile::app {

void doElsewhere(std::function<void()> work) {
    // The application waits for the pool at its end; without one there is no window either.
    const QCoreApplication* application = QCoreApplication::instance();
    if (application && QThread::currentThread() == application->thread()) {
        QThreadPool::globalInstance()->start(std::move(work));
    } else {
        work();
    }
}

}  // namespace toile::app
