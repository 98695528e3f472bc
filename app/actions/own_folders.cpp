// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/own_folders.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace toile::app {

QStringList samplePaths() {
    QStringList folders = {
        QDir(QCoreApplication::applicationDirPath()).filePath("../share/toile/samples"),
        QDir(QCoreApplication::applicationDirPath()).filePath("samples")};
#ifdef TOILE_SAMPLES_DIR
    folders << TOILE_SAMPLES_DIR;
#endif
    for (const QString& folder : folders) {
        QStringList paths;
        const QFileInfoList files = QDir(folder).entryInfoList({"*.obj"}, QDir::Files, QDir::Name);
        for (const QFileInfo& file : files) {
            paths << file.absoluteFilePath();
        }
        if (!paths.isEmpty()) {
            return paths;
        }
    }
    return {};
}

QString documentationPage(const QString& name) {
    QStringList folders = {
        QDir(QCoreApplication::applicationDirPath()).filePath("../share/doc/toile")};
#ifdef TOILE_DOCS_DIR
    folders << TOILE_DOCS_DIR;
#endif
    for (const QString& folder : folders) {
        if (const QFileInfo page(QDir(folder), name); page.isFile()) {
            return page.absoluteFilePath();
        }
    }
    return {};
}

QString writingFolder(const QString& garment, const QString& project) {
    const QString beside = QFileInfo(project.isEmpty() ? garment : project).absolutePath();
    const QStringList samples = samplePaths();
    const bool isOurs =
        !samples.isEmpty() && QFileInfo(samples.front()).absoluteDir() == QDir(beside);
    if (!isOurs && QFileInfo(beside).isWritable()) {
        return beside;
    }
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

}  // namespace toile::app
