// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QStringList>
#include <QVariant>
#include <memory>
#include <optional>

#include "app/settings/choices.h"
#include "core/formats/export_options.h"

class QSettings;

namespace toile::app {

/// Stored settings of the user, typed. The only class that knows the setting names.
class Preferences : public QObject {
    Q_OBJECT

public:
    /// Uses the user's own settings.
    Preferences();
    /// Uses the given file. With an empty path, nothing outlives this object.
    explicit Preferences(const QString& file);
    ~Preferences() override;

    /// The choices of the preferences dialog. Invalid stored values read as the default.
    const Choices& choices() const { return choices_; }
    /// Takes effect at once.
    void setChoices(const Choices& choices);

    /// Folder of the last opened garment; the home folder at first.
    QString openFolder() const;
    void setOpenFolder(const QString& folder);
    /// Folder of the last export; empty at first, which means the garment's folder.
    QString exportFolder() const;
    void setExportFolder(const QString& folder);

    /// Format of the last export as an extension, such as ".svg".
    QString exportFormat() const;
    void setExportFormat(const QString& ending);
    ExportOptions exportOptions() const;
    void setExportOptions(const ExportOptions& options);

    /// Minutes that the user needs to sew a metre of seam, if entered.
    std::optional<double> sewingRate() const;
    void setSewingRate(double minutes);

    /// Recent files, latest first: the files of one garment each, or a project file.
    QList<QStringList> recentFiles() const;
    void setRecentFiles(const QList<QStringList>& files);

    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    QByteArray windowState() const;
    void setWindowState(const QByteArray& state);
    /// Hidden columns of the table with this settings name; none if the user never chose any.
    std::optional<QStringList> hiddenColumns(const QString& table) const;
    void setHiddenColumns(const QString& table, const QStringList& columns);

signals:
    /// Emitted after a change; `before` holds the previous choices.
    void choicesChanged(const toile::app::Choices& before);
    void recentFilesChanged();

private:
    void readChoices();
    QVariant read(const QString& key, const QVariant& atFirst = {}) const;
    void write(const QString& key, const QVariant& value);

    std::unique_ptr<QSettings> settings_;  ///< null if nothing is stored
    QVariantMap kept_;                     ///< used instead of settings_
    Choices choices_;
};

}  // namespace toile::app
