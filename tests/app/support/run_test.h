// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QTest>

#include "app/render/gl_support.h"

namespace toile::test {

/// How long a test waits for what is sure to come, milliseconds: long for a slow machine that does
/// much else.
inline constexpr int kPatience = 60000;

/// What has to be said before there is an application: the views' surface format.
void prepareApplication();
/// The program's own files, and the C locale.
void prepareTest();

/// Runs a test as an application like the program's own. For `main`.
template <class Test>
int run(int argc, char** argv) {
    prepareApplication();
    QApplication application(argc, argv);
    prepareTest();
    Test test;
    return QTest::qExec(&test, argc, argv);
}

}  // namespace toile::test

/// Skips a test by name where no OpenGL 3.3 context can be made.
#define SKIP_WITHOUT_GL()                           \
    do {                                            \
        const QString problem = toile::glProblem(); \
        if (!problem.isEmpty()) {                   \
            QSKIP(qPrintable(problem));             \
        }                                           \
    } while (false)
