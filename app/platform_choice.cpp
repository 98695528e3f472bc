// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platform_choice.h"

#include <QCoreApplication>
#include <QLibrary>
#include <QPluginLoader>
#include <algorithm>
#include <iostream>

// The macro declares a function and has to stand outside of any namespace.
static void registerResources() {
    Q_INIT_RESOURCE(toile);
    Q_INIT_RESOURCE(translations);
}

namespace toile::app {

void loadResources() {
    registerResources();
}

void quietenQt() {
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& message) {
        if (type == QtCriticalMsg || type == QtFatalMsg) {
            std::cerr << "toile: " << message.toStdString() << '\n';
        }
    });
}

#ifdef Q_OS_LINUX

namespace {

/// Translation context.
class PlatformWords {
    Q_DECLARE_TR_FUNCTIONS(PlatformChoice)
};

/// Loads libxcb, like Qt's xcb plugin; without it, that plugin cannot work either.
template <class Function>
Function* ofXcb(const char* name) {
    static QLibrary xcb("xcb", 1);
    return reinterpret_cast<Function*>(xcb.resolve(name));
}

bool canLoadPlatform(const QString& name) {
    const QStringList folders = QCoreApplication::libraryPaths();  // includes QT_PLUGIN_PATH
    return std::ranges::any_of(folders, [&](const QString& folder) {
        return QPluginLoader(folder + "/platforms/libq" + name).load();
    });
}

}  // namespace

DisplayProbe::DisplayProbe() {
    if (qEnvironmentVariableIsEmpty("DISPLAY")) {
        return;
    }
    const auto connect = ofXcb<void*(const char*, int*)>("xcb_connect");
    const auto problem = ofXcb<int(void*)>("xcb_connection_has_error");
    if (connect && problem && ofXcb<void(void*)>("xcb_disconnect")) {
        connection_ = connect(nullptr, nullptr);
        answers_ = problem(connection_) == 0;
    }
}

DisplayProbe::~DisplayProbe() {
    if (connection_) {
        ofXcb<void(void*)>("xcb_disconnect")(connection_);
    }
}

QString windowProblem(const DisplayProbe& display) {
    // Respect an explicit platform, and Wayland.
    if (!qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY")) {
        return {};
    }
    const QString named = qEnvironmentVariable("QT_QPA_PLATFORM");
    if (!named.isEmpty() && !named.startsWith("xcb")) {
        return {};
    }
    if (display.answers()) {
        return {};
    }
    return PlatformWords::tr(
        "there is no display for the window; use xvfb-run, or \"toile flatten\" and \"toile "
        "render\", which need none");
}

QString choosePicturePlatform(const DisplayProbe& display) {
    if (display.answers() && canLoadPlatform("xcb")) {
        qputenv("QT_QPA_PLATFORM", "xcb");
        return {};
    }
    if (!canLoadPlatform("offscreen")) {
        return PlatformWords::tr(
            "there is no display, and Qt's offscreen plugin is not installed; use xvfb-run");
    }
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Otherwise Qt's plugin would look for a display and print warnings.
    qunsetenv("DISPLAY");
    return {};
}

#else

DisplayProbe::DisplayProbe() = default;

DisplayProbe::~DisplayProbe() = default;

QString windowProblem(const DisplayProbe&) {
    return {};
}

QString choosePicturePlatform(const DisplayProbe&) {
    return {};
}

#endif

}  // namespace toile::app
