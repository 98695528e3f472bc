// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/run_test.h"

#include <QLocale>
#include <QSurfaceFormat>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>

#include "app/export/paint_drawing.h"
#include "app/platform_choice.h"
#include "app/report_pictures.h"

namespace toile::test {

using namespace app;

namespace {

constexpr char kLimit[] = "QTEST_FUNCTION_TIMEOUT";

std::map<std::string, int (*)(int, char**), std::less<>>& tests() {
    static std::map<std::string, int (*)(int, char**), std::less<>> all;
    return all;
}

}  // namespace

bool add(std::string_view file, int (*run)(int, char**)) {
    constexpr std::string_view kEnd = "_test.cpp";
    file.remove_prefix(file.rfind('/') + 1);
    file.remove_suffix(kEnd.size());
    return tests().emplace(file, run).second;
}

void prepareApplication() {
    // Qt ends a test function after five minutes, which a slow machine that does much else may
    // take. How long a program may take is CTest's affair.
    if (!qEnvironmentVariableIsSet(kLimit)) {
        qputenv(kLimit, QByteArray::number(60 * kPatience));
    }
    QSurfaceFormat::setDefaultFormat(sceneSurfaceFormat());
    // Letters have one size on every display.
    QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
}

void prepareTest() {
    loadResources();
    provideWriters();
    provideReportPictures(reportPictures);
    QLocale::setDefault(QLocale::c());
}

}  // namespace toile::test

/// toile_window_test NAME [ARGUMENTS OF QTEST...]: one test a process, so that none finds what
/// another has left.
int main(int argc, char** argv) {
    const auto& tests = toile::test::tests();
    const auto test = argc > 1 ? tests.find(std::string_view(argv[1])) : tests.end();
    if (test == tests.end()) {
        for (const auto& [name, run] : tests) {
            std::puts(name.c_str());
        }
        return argc > 1 ? 2 : 0;
    }
    argv[1] = argv[0];
    return test->second(argc - 1, argv + 1);
}
