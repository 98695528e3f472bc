// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QStringList>
#include <QVariant>
#include <memory>

#include "app/settings/choices.h"

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
    /// Takes hold at once: emits a signal for everything that is another now.
    void setChoices(const Choices& choices);
    Navigation navigation() const { return choices_.navigation; }
    Theme theme() const { return choices_.theme; }
    Language language() const { return choices_.language; }
    int autosaveMinutes() const { return choices_.autosaveMinutes; }
    int autoFlattenTriangles() const { return choices_.autoFlattenTriangles; }

    /// Where the last garment was opened; the home folder at first.
    QString openFolder() const;
    void setOpenFolder(const QString& folder);
    /// Where the last export went; the folder of the garment at first (empty here).
    QString exportFolder() const;
    void setExportFolder(const QString& folder);

    /// What was opened last, the latest first: the files of a garment each, or a project file.
    QList<QStringList> recentFiles() const;
    void setRecentFiles(const QList<QStringList>& files);

    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    QByteArray windowState() const;
    void setWindowState(const QByteArray& state);
    /// Columns of a table by the name they are kept under; none: never chosen.
    QStringList hiddenColumns(const QString& table, const QStringList& atFirst) const;
    void setHiddenColumns(const QString& table, const QStringList& columns);

signals:
    void lengthUnitChanged();
    void themeChanged();
    void navigationChanged();
    void coloursChanged();
    void autosaveMinutesChanged();
    void autoFlattenTrianglesChanged();
    void recentFilesChanged();

private:
    void readChoices();
    void writeChoices();
    QVariant read(const QString& key, const QVariant& atFirst = {}) const;
    void write(const QString& key, const QVariant& value);

    std::unique_ptr<QSettings> settings_;  ///< null where nothing is remembered
    QVariantMap kept_;                     ///< in its place
    Choices choices_;
};

}  // namespace toile::app
