// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace toile::app {

/// The sample garments that come with the program; none where they are not installed.
QStringList samplePaths();

/// A page of the documentation that comes with the program, "first-steps.md"; empty where it is not
/// installed.
QString documentationPage(const QString& name);

/// The folder where a person is likely to want what is made of a garment: beside the project, else
/// beside the garment; of a sample, or where nothing can be written, the documents.
/// @param garment  its first file  @param project  its file, or empty
QString writingFolder(const QString& garment, const QString& project);

}  // namespace toile::app
