// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/own_folders.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace toile::app {

namespace {

/// Shared files of an installation; a build tree has links there.
QDir shared(const char* path) {
    return QDir(QCoreApplication::applicationDirPath() + "/../share/" + path);
}

}  // namespace

QStringList samplePaths() {
    QStringList paths;
    for (const QFileInfo& file :
         shared("toile/samples").entryInfoList({"*.obj"}, QDir::Files, QDir::Name)) {
        paths << file.canonicalFilePath();
    }
    return paths;
}

QString documentationPage(const QString& name) {
    const QFileInfo page(shared("doc/toile"), name);
    return page.isFile() ? page.canonicalFilePath() : QString();
}

QString writingFolder(const QString& garment, const QString& project) {
    const QString beside = QFileInfo(project.isEmpty() ? garment : project).absolutePath();
    const QStringList samples = samplePaths();
    const bool isOurs = !samples.isEmpty() && QFileInfo(samples.front()).absolutePath() ==
                                                  QFileInfo(beside).canonicalFilePath();
    if (!isOurs && QFileInfo(beside).isWritable()) {
        return beside;
    }
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

}  // namespace toile::app
