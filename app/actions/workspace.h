// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/document/document.h"
#include "app/jobs/job_runner.h"

namespace toile {

/// What a person can ask of the open garment, without any widget: opening, flattening, writing.
/// Each wish becomes a job; results arrive in the document. GUI thread only.
class Workspace : public QObject {
    Q_OBJECT

public:
    using Paths = std::vector<std::filesystem::path>;

    explicit Workspace(QObject* parent = nullptr);
    ~Workspace() override;

    Document& document() { return document_; }
    JobRunner& jobs() { return jobs_; }
    const std::optional<LengthUnit>& unit() const { return unit_; }

    /// Reads the files as one garment and flattens it. Whatever ran before is cancelled.
    void open(Paths files);
    /// Unit of the files; none: guessed. Reads an open garment again.
    void setUnit(std::optional<LengthUnit> unit);
    void setMethod(Method method);
    void setBoundarySolver(BoundarySolver solver);
    void flattenAgain();
    /// True where there are results to write.
    bool canExport() const;
    /// Requires canExport. The ending chooses the format.
    void exportTo(const std::filesystem::path& path);

signals:
    void exported(const QString& path);

private:
    void onChanged(DocumentChanges what);
    void onOver();

    Document document_;
    JobRunner jobs_{document_};
    Paths requested_;  ///< what was opened last, for reading it again
    std::optional<LengthUnit> unit_;
    bool importing_ = false;
};

}  // namespace toile
