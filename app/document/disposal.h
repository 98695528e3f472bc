// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QThread>
#include <QThreadPool>
#include <memory>

namespace toile::app {

/// Shares a large value that is never destroyed on the window's thread: freeing some hundred
/// megabytes takes longer than the window may be blocked.
template <class Value>
std::shared_ptr<Value> sharedForDisposal(std::unique_ptr<Value> value) {
    return std::shared_ptr<Value>(value.release(), [](Value* old) {
        // The application waits for the pool at its end; without one there is no window either.
        const QCoreApplication* application = QCoreApplication::instance();
        if (application && QThread::currentThread() == application->thread()) {
            QThreadPool::globalInstance()->start([old] { delete old; });
        } else {
            delete old;
        }
    });
}

}  // namespace toile::app
