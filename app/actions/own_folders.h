// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace toile::app {

/// The installed sample garments; empty if they are not installed.
QStringList samplePaths();

/// Path of an installed documentation page, such as "first-steps.md"; empty if it is not installed.
QString documentationPage(const QString& name);

/// Default folder for files made from a garment: that of the project, else that of the garment. For
/// samples and folders without write permission it is the documents folder.
/// @param garment  its first file  @param project  its file, or empty
QString writingFolder(const QString& garment, const QString& project);

}  // namespace toile::app
