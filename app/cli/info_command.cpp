// SPDX-License-Identifier: GPL-3.0-or-later
#include <ostream>

#include "app/cli/arguments.h"
#include "app/cli/command_line.h"
#include "app/cli/commands.h"
#include "app/cli/table.h"
#include "core/base/text.h"
#include "core/pipeline/pipeline.h"

namespace toile {
namespace {

void printFile(const SourceFile& file, std::ostream& out) {
    out << file.path.string() << ": " << counted(file.soup.faceCount(), "face") << ", "
        << counted(static_cast<long long>(file.soup.positions.size()), "vertex") << ", unit "
        << symbol(file.unit);
    if (!file.unitReason.empty()) {
        out << " (" << file.unitReason << ")";
    }
    out << '\n';
    for (const Error& problem : file.problems) {
        out << "  note: " << sentence(problem) << '\n';
    }
}

std::vector<std::string> rowOf(const Piece& piece) {
    const auto size =
        (piece.mesh.V.colwise().maxCoeff() - piece.mesh.V.colwise().minCoeff()).eval();
    return {piece.name,
            std::to_string(piece.mesh.V.rows()),
            std::to_string(piece.mesh.F.rows()),
            piece.defect ? "-" : std::to_string(piece.boundary.size()),
            fixed(size.x(), 0) + " x " + fixed(size.y(), 0) + " x " + fixed(size.z(), 0),
            piece.defect ? std::string(name(piece.defect->code)) : "disk"};
}

}  // namespace

int runInfo(const Arguments& arguments, std::ostream& out, std::ostream& err) {
    Progress progress;
    const auto garment = loadGarment(arguments.inputs,
                                     {arguments.unit, arguments.split, arguments.strict}, progress);
    if (!garment) {
        err << "toile: " << sentence(garment.error()) << '\n';
        return kExitUnreadable;
    }
    for (const auto& file : garment->files) {
        printFile(*file, out);
    }
    Table table({"piece", "vertices", "triangles", "boundary edges", "size mm", "kind"});
    for (const auto& piece : garment->pieces) {
        table.add(rowOf(*piece));
    }
    table.print(out);
    int status = kExitDone;
    for (const auto& piece : garment->pieces) {
        if (piece->defect) {
            err << "toile: " << sentence(*piece->defect) << '\n';
            status = kExitSomeFailed;
        }
    }
    return status;
}

}  // namespace toile
