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

/// What the program remembers of the person, typed. The only place that knows setting names.
class Preferences : public QObject {
    Q_OBJECT

public:
    /// The person's own settings.
    Preferences();
    /// Kept in a file of its own; with an empty path nothing is remembered past this object.
    explicit Preferences(const QString& file);
    ~Preferences() override;

    /// What the preferences dialog is about. Values that no version ever wrote read as the default.
    const Choices& choices() const { return choices_; }
    /// Takes hold at once.
    void setChoices(const Choices& choices);

    /// Where the last garment was opened; the home folder at first.
    QString openFolder() const;
    void setOpenFolder(const QString& folder);
    /// Where the last export went; the folder of the garment at first (empty here).
    QString exportFolder() const;
    void setExportFolder(const QString& folder);

    /// What was exported last, and how; an ending, such as ".svg".
    QString exportFormat() const;
    void setExportFormat(const QString& ending);
    ExportOptions exportOptions() const;
    void setExportOptions(const ExportOptions& options);

    /// Minutes that a metre of seam takes the person to sew; none: never said.
    std::optional<double> sewingRate() const;
    void setSewingRate(double minutes);

    /// What was opened last, the latest first: the files of a garment each, or a project file.
    QList<QStringList> recentFiles() const;
    void setRecentFiles(const QList<QStringList>& files);

    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    QByteArray windowState() const;
    void setWindowState(const QByteArray& state);
    /// Columns of a table by the name they are kept under; none: never chosen.
    std::optional<QStringList> hiddenColumns(const QString& table) const;
    void setHiddenColumns(const QString& table, const QStringList& columns);

signals:
    /// They are others than these.
    void choicesChanged(const toile::app::Choices& before);
    void recentFilesChanged();

private:
    void readChoices();
    QVariant read(const QString& key, const QVariant& atFirst = {}) const;
    void write(const QString& key, const QVariant& value);

    std::unique_ptr<QSettings> settings_;  ///< null where nothing is remembered
    QVariantMap kept_;                     ///< in its place
    Choices choices_;
};

}  // namespace toile::app
