// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <benchmark/benchmark.h>

namespace toile::bench {

/// How much of the benchmarks is to run.
struct Scope {
    bool quick = false;     ///< nothing above 45 000 triangles, few repetitions
    bool slowPeers = true;  ///< peers that take minutes
    bool allows(const std::string& size) const { return !quick || std::stoi(size) <= 45000; }
};

/// Each registers one family with Google Benchmark; nothing is measured or made before they run.
/// Names are what/piece/how, see report/measurements.h.
void registerFloor(const Scope& scope);       ///< floor/panel/45000/amd-simplicial, trap/...
void registerFlattening(const Scope& scope);  ///< curvature/panel/45000, isometric/dress, ...
void registerPieces(const Scope& scope);      ///< buildPiece/panel/45000
void registerReading(const Scope& scope);     ///< plainScan, toileReader, openMeshReader
void registerPreparing();                     ///< prepare/dress_scan/remeshed-10
void registerTailor();                        ///< tailor/advice
void registerWriting(const Scope& scope);     ///< write/panel/1000000/svg
void registerExport();                        ///< export/dress/pdf, readBack/dress/all
void registerGarment(const Scope& scope);     ///< garment/dress/threads-2
void registerEndToEnd(const Scope& scope);    ///< endToEnd/panel/1000000/curvature
void registerMemory(const Scope& scope);      ///< memory/panel/1000000/curvature
void registerResolve(const Scope& scope);     ///< resolveDart/panel/45000/curvature, coldDart/...
void registerOutline(const Scope& scope);  ///< outline/isometric/200000, by vertices of the outline
void registerAllowances(const Scope& scope);  ///< allowance/line/3000, by points of the outline
void registerFairing(const Scope& scope);     ///< fair/line/1500, by millimetres of the outline
void registerPeers(const Scope& scope);       ///< cgalLscm/panel/45000

/// Single benchmarks of those families, for the guard.
/// @param losers  with the candidates that never win at this size
void registerFloorOf(const std::string& piece, int repetitions, bool losers);
void registerFlatteningOf(const std::string& method, const std::string& piece, int repetitions);

/// Sets the usual ways of measuring: milliseconds, processor time of all threads, and so many
/// repetitions of at least a twentieth of a second, but of one round where one takes longer.
benchmark::internal::Benchmark* measured(benchmark::internal::Benchmark* benchmark,
                                         int repetitions);
/// How often to repeat what is about linear in the size and takes seconds at a million.
int repetitionsFor(const std::string& piece, const Scope& scope);

}  // namespace toile::bench
