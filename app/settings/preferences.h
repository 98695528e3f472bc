// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <memory>

class QSettings;

namespace toile {

/// What the program remembers of the person, typed. The only place that knows setting names.
class Preferences {
public:
    /// The person's own settings.
    Preferences();
    /// Kept in a file of its own; with an empty path nothing is remembered past this object.
    explicit Preferences(const QString& file);
    ~Preferences();

    /// Where the last garment was opened; the home folder at first.
    QString openFolder() const;
    void setOpenFolder(const QString& folder);
    /// Where the last export went; the folder of the garment at first (empty here).
    QString exportFolder() const;
    void setExportFolder(const QString& folder);

    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    QByteArray windowState() const;
    void setWindowState(const QByteArray& state);

private:
    std::unique_ptr<QSettings> settings_;  ///< null where nothing is remembered
    QString openFolder_, exportFolder_;
};

}  // namespace toile
