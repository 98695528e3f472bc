// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/preferences.h"

#include <QDir>
#include <QSettings>

namespace toile {

namespace {

constexpr auto kOpenFolder = "folders/open";
constexpr auto kExportFolder = "folders/export";
constexpr auto kGeometry = "window/geometry";
constexpr auto kState = "window/state";

}  // namespace

Preferences::Preferences() : settings_(std::make_unique<QSettings>("Toile", "Toile")) {
    openFolder_ = settings_->value(kOpenFolder).toString();
    exportFolder_ = settings_->value(kExportFolder).toString();
}

Preferences::Preferences(const QString& file) {
    if (file.isEmpty()) {
        return;
    }
    settings_ = std::make_unique<QSettings>(file, QSettings::IniFormat);
    openFolder_ = settings_->value(kOpenFolder).toString();
    exportFolder_ = settings_->value(kExportFolder).toString();
}

Preferences::~Preferences() = default;

QString Preferences::openFolder() const {
    return openFolder_.isEmpty() || !QDir(openFolder_).exists() ? QDir::homePath() : openFolder_;
}

void Preferences::setOpenFolder(const QString& folder) {
    openFolder_ = folder;
    if (settings_) {
        settings_->setValue(kOpenFolder, folder);
    }
}

QString Preferences::exportFolder() const {
    return QDir(exportFolder_).exists() ? exportFolder_ : QString();
}

void Preferences::setExportFolder(const QString& folder) {
    exportFolder_ = folder;
    if (settings_) {
        settings_->setValue(kExportFolder, folder);
    }
}

QByteArray Preferences::windowGeometry() const {
    return settings_ ? settings_->value(kGeometry).toByteArray() : QByteArray();
}

void Preferences::setWindowGeometry(const QByteArray& geometry) {
    if (settings_) {
        settings_->setValue(kGeometry, geometry);
    }
}

QByteArray Preferences::windowState() const {
    return settings_ ? settings_->value(kState).toByteArray() : QByteArray();
}

void Preferences::setWindowState(const QByteArray& state) {
    if (settings_) {
        settings_->setValue(kState, state);
    }
}

}  // namespace toile
