// SPDX-License-Identifier: GPL-3.0-or-later
// What other programs read of our DXF files, where they are installed.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/core/formats/exported_garments.h"
#include "tests/core/support/temporary_folder.h"

namespace toile {
namespace {

/// What a command says; none where it fails.
std::string saidBy(const std::string& command, const test::TemporaryFolder& folder) {
    const std::string out = (folder / "said").string();
    const int status = std::system((command + " >'" + out + "' 2>/dev/null").c_str());
    return status == 0 ? folder.read("said") : std::string();
}

std::string pythonWithEzdxf(const test::TemporaryFolder& folder) {
    for (const char* python : {"python3", "/usr/bin/python3"}) {
        if (!saidBy(std::string(python) + " -c 'import ezdxf; print(1)'", folder).empty()) {
            return python;
        }
    }
    return {};
}

/// Of each file faults, blocks, inserts, closed lines of what is cut, key points, and the extent of
/// these lines in the file's unit.
constexpr const char* kScript = R"(
import ezdxf, sys
for name in sys.argv[1:]:
    document = ezdxf.readfile(name)
    faults = len(document.audit().errors)
    blocks = [b for b in document.blocks if not b.name.startswith(('*', '$'))]
    lines, points = [], 0
    for place in blocks or [document.modelspace()]:
        for entity in place:
            layer = entity.dxf.layer
            if entity.dxftype() == 'POLYLINE' and entity.is_closed and layer in ('1', 'CUT'):
                lines.append([v.dxf.location for v in entity.vertices])
            points += entity.dxftype() == 'POINT' and layer in ('2', '3')
    inserts = sum(e.dxftype() == 'INSERT' for e in document.modelspace())
    xs = [p[0] for line in lines for p in line]
    ys = [p[1] for line in lines for p in line]
    print(faults, len(blocks), inserts, len(lines), points, min(xs), min(ys), max(xs), max(ys))
)";

struct Measured {
    bool isPlain;
    double millimetres;  ///< of its unit
};

TEST(DxfClients, EzdxfFindsNoFaultAndTheSameExtents) {
    const test::TemporaryFolder folder;
    const std::string python = pythonWithEzdxf(folder);
    if (python.empty()) {
        GTEST_SKIP() << "ezdxf is not installed";
    }
    std::ofstream(folder / "read.py") << kScript;
    const test::ExportedGarment made = test::exported("samples/bodice.obj", true);
    const ExportSource source = made.source();
    Eigen::AlignedBox2d box;
    std::size_t cuts = 0;
    for (const DrawnPath& path : source.drawing().paths) {
        if (path.layer == LayerKind::Cut) {
            ++cuts;
            for (Eigen::Index k = 0; k < path.points.rows(); ++k) {
                box.extend(path.points.row(k).transpose());
            }
        }
    }
    const std::size_t pieces = source.drawing().blocks.size();
    std::string command = python + " '" + (folder / "read.py").string() + "'";
    std::vector<Measured> files;
    for (const DxfProfile profile : {DxfProfile::Astm, DxfProfile::Aama, DxfProfile::Plain}) {
        for (const LengthUnit unit :
             {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Inch}) {
            const auto file = folder / (std::to_string(files.size()) + ".dxf");
            std::ofstream(file, std::ios::binary)
                << test::dxfOf(made, test::dxfOptions(profile, unit));
            command += " '" + file.string() + "'";
            files.push_back({profile == DxfProfile::Plain, millimetresPer(unit)});
        }
    }
    std::istringstream said(saidBy(command, folder));
    for (const auto& [isPlain, millimetres] : files) {
        std::size_t faults = 1, blocks = 0, inserts = 0, lines = 0, points = 0;
        Eigen::Vector2d low(0, 0), high(0, 0);
        said >> faults >> blocks >> inserts >> lines >> points >> low.x() >> low.y() >> high.x() >>
            high.y();
        EXPECT_TRUE(said);
        EXPECT_EQ(faults, 0U);
        EXPECT_EQ(blocks, isPlain ? 0 : pieces);
        EXPECT_EQ(inserts, isPlain ? 0 : pieces);
        EXPECT_EQ(lines, isPlain ? cuts : pieces);
        EXPECT_EQ(points > 0, !isPlain);
        // Key points leave out what is as near to a chord as they may be.
        const double within = isPlain ? 1e-3 : 0.1;
        EXPECT_LT((low * millimetres - box.min()).cwiseAbs().maxCoeff(), within);
        EXPECT_LT((high * millimetres - box.max()).cwiseAbs().maxCoeff(), within);
    }
}

TEST(DxfClients, LibreCadPrintsEveryProfile) {
    const test::TemporaryFolder folder;
    if (std::system("command -v librecad >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "librecad is not installed";
    }
    const test::ExportedGarment made = test::exported("samples/tshirt.obj", true);
    for (const DxfProfile profile : {DxfProfile::Astm, DxfProfile::Aama, DxfProfile::Plain}) {
        std::ofstream(folder / "a.dxf", std::ios::binary)
            << test::dxfOf(made, test::dxfOptions(profile));
        const std::string pdf = (folder / "a.pdf").string();
        saidBy("QT_QPA_PLATFORM=offscreen timeout 60 librecad dxf2pdf -a -o '" + pdf + "' '" +
                   (folder / "a.dxf").string() + "'",
               folder);
        EXPECT_GT(folder.read("a.pdf").size(), 1000U);
        std::remove(pdf.c_str());
    }
}

}  // namespace
}  // namespace toile
