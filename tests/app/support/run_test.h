// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QTest>
#include <string_view>

#include "app/render/gl_support.h"

namespace toile::test {

using namespace app;

/// How long a test waits for an event that must come, milliseconds. Long enough for a slow and busy
/// machine.
inline constexpr int kPatience = 60000;

/// Settings that must precede the application, such as the surface format of the views.
void prepareApplication();
/// Loads the program's resources and writers, and sets the C locale.
void prepareTest();

/// Runs a test as an application like the program's own.
template <class Test, class Application = QApplication>
int run(int argc, char** argv) {
    prepareApplication();
    Application application(argc, argv);
    prepareTest();
    Test test;
    return QTest::qExec(&test, argc, argv);
}

/// Registers a test in the program that contains all of them, by its file: `NAME_test.cpp` is NAME.
/// @return true
bool add(std::string_view file, int (*run)(int argc, char** argv));

}  // namespace toile::test

/// `TOILE_WINDOW_TEST(Test)` or `TOILE_WINDOW_TEST(Test, Application)`, once in a file.
#define TOILE_WINDOW_TEST(Test, ...)    \
    static const bool is##Test##Known = \
        toile::test::add(__FILE__, toile::test::run<Test __VA_OPT__(, ) __VA_ARGS__>);

/// Skips a test if no OpenGL 3.3 context can be created.
#define SKIP_WITHOUT_GL()                                \
    do {                                                 \
        const QString problem = toile::app::glProblem(); \
        if (!problem.isEmpty()) {                        \
            QSKIP(qPrintable(problem));                  \
        }                                                \
    } while (false)
