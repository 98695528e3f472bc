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
    /// How files are read, divided and cut.
    const LoadOptions& loading() const { return loading_; }
    /// The files of the document's garment.
    Paths openPaths() const;

    /// Reads the files as one garment and flattens it. Whatever ran before is cancelled. Files
    /// other than those before begin anew: the unit, the up axis, cuts and ease that were stated
    /// were said about another garment.
    void open(Paths files);
    /// Reads the open garment's files again, as they are on the disk now.
    void reload();
    /// Reads an open garment again with these options.
    void setLoading(LoadOptions loading);
    /// Unit of the files; none: guessed. Reads an open garment again where that is a change.
    void setUnit(std::optional<LengthUnit> unit);
    /// The axis that points up in the files; none: guessed. As setUnit.
    void setUpAxis(std::optional<UpAxis> up);
    /// By what files are divided. As setUnit.
    void setSplit(SplitMode split);
    /// Whether pieces that are no disks are cut open. As setUnit.
    void setAutoCut(bool on);
    /// Whether vertices that lie on each other are joined. As setUnit.
    void setWeld(bool on);
    /// Takes cuts and ease from a seams file. Nothing changes where it cannot be read.
    Result<void> readSeams(const std::filesystem::path& path);
    /// Writes the cuts and the ease that were stated as a seams file.
    Result<void> writeSeams(const std::filesystem::path& path) const;
    /// Takes a cut of the user's back, the first of this name. Reads an open garment again.
    void removeCut(const std::string& name);
    /// Says how much longer a seam's left side is meant to be, as a part of the right; none: as
    /// the 3D lengths have it. Nothing is read or flattened again; a later reading keeps it.
    void setEase(int seam, std::optional<double> ease);
    void setMethod(Method method);
    void setQuality(Quality quality);
    void setBoundarySolver(BoundarySolver solver);
    void flattenAgain();
    /// True where there are results to write.
    bool canExport() const;
    /// Requires canExport. The ending chooses the format.
    void exportTo(const std::filesystem::path& path);

signals:
    /// `loading` is another now.
    void loadingChanged();
    void exported(const QString& path);

private:
    void read();
    template <class Value>
    void change(Value LoadOptions::*field, const Value& value);
    void onChanged(DocumentChanges what);
    void onOver();

    Document document_;
    JobRunner jobs_{document_};
    Paths requested_;  ///< what was opened last, for reading it again
    LoadOptions loading_;
    LoadOptions loaded_;  ///< as the document's garment was read
    bool importing_ = false;
};

}  // namespace toile
