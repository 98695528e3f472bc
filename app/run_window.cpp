// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_window.h"

#include <QApplication>
#include <QIcon>
#include <QTimer>
#include <cstdio>
#include <utility>

#include "app/main_window.h"
#include "app/render/gl_support.h"
#include "app/resources.h"
#include "app/settings/preferences.h"
#include "app/views/view_area.h"
#include "app/widgets/banner.h"
#include "core/base/version.h"

namespace toile {

namespace {

constexpr int kPollMilliseconds = 50;
/// Exit statuses, as the command line's.
constexpr int kFailed = 1, kUnreadable = 3;

QStringList toStrings(const std::vector<std::filesystem::path>& paths) {
    QStringList list;
    for (const auto& path : paths) {
        list << QString::fromStdU16String(path.u16string());
    }
    return list;
}

void complain(const QString& sentence) {
    std::fputs(qPrintable("toile: " + sentence + '\n'), stderr);
}

/// Qt ends the program with a signal where it finds no display; a sentence is kinder.
bool displayIsMissing() {
#ifdef Q_OS_LINUX
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        if (!qEnvironmentVariableIsEmpty(name)) {
            return false;
        }
    }
    return true;
#else
    return false;
#endif
}

/// Waits until the views show the result, then writes the picture and leaves the event loop.
class Photographer : public QObject {
public:
    Photographer(MainWindow& window, QString path) : window_(window), path_(std::move(path)) {
        connect(&timer_, &QTimer::timeout, this, [this] { look(); });
        timer_.start(kPollMilliseconds);
    }

private:
    void look() {
        Workspace& workspace = window_.workspace();
        if (workspace.jobs().isBusy()) {
            return;
        }
        if (!window_.banner().isHidden()) {
            complain(window_.banner().sentence());
            QApplication::exit(kUnreadable);
            return;
        }
        const bool empty = workspace.document().garment() == nullptr;
        if (!empty && !window_.views().isUpToDate()) {
            return;
        }
        // One more round lets layouts and the window's other parts settle.
        if (++quietRounds_ < 4) {
            return;
        }
        timer_.stop();
        const bool written = window_.grab().save(path_);
        if (!written) {
            complain(QApplication::translate("RunWindow", "could not write %1").arg(path_));
        }
        QApplication::exit(written ? 0 : kFailed);
    }

    MainWindow& window_;
    QString path_;
    QTimer timer_;
    int quietRounds_ = 0;
};

/// The lists come in with the first garment.
void showOnceOpen(MainWindow& window, Panel panel) {
    QObject::connect(
        &window.workspace().document(), &Document::changed, &window,
        [&window, panel, shown = false](DocumentChanges what) mutable {
            if (what.testFlag(DocumentChange::Garment) && !std::exchange(shown, true)) {
                window.goTo(panel);
            }
        });
}

}  // namespace

int runWindow(int argc, char** argv, const WindowOptions& options) {
    if (displayIsMissing()) {
        complain(
            "there is no display to open the window on; \"toile flatten\" needs none, and "
            "xvfb-run lends one");
        return kUnreadable;
    }
    loadResources();
    QSurfaceFormat::setDefaultFormat(sceneSurfaceFormat());
    QApplication application(argc, argv);
    const std::string_view number = version();
    QApplication::setApplicationName("Toile");
    QApplication::setApplicationVersion(
        QString::fromUtf8(number.data(), static_cast<qsizetype>(number.size())));
    QApplication::setWindowIcon(QIcon(":/icons/toile.svg"));

    const bool photograph = !options.screenshot.empty();
    // A picture must not depend on, nor change, what a person has set.
    Preferences forgetful{QString()};
    Preferences own;
    MainWindow window(photograph ? forgetful : own);
    if (photograph) {
        window.resize(options.width, options.height);
    }
    LoadOptions load = options.load;
    if (!options.seams.empty()) {
        auto seams = readSeamsFile(options.seams);
        if (!seams) {
            complain(QString::fromStdString(sentence(seams.error())));
            return kUnreadable;
        }
        load.seams = std::move(*seams);
    }
    window.workspace().setLoading(std::move(load));
    window.workspace().document().setOptions(options.flattening);
    window.workspace().document().setOverlay(options.overlay);
    window.show();
    if (!options.files.empty()) {
        window.openFiles(toStrings(options.files));
    }
    if (options.panel) {
        showOnceOpen(window, *options.panel);
    }
    std::optional<Photographer> photographer;
    if (photograph) {
        photographer.emplace(window, QString::fromStdU16String(options.screenshot.u16string()));
    }
    return QApplication::exec();
}

}  // namespace toile
