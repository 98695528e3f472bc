// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile {

/// OpenBLAS picks its kernels by the processor's name. One newer than itself it does not know, and
/// falls back to kernels of twenty years ago: large factorisations take twice as long (Debian 12's
/// 0.3.21 on Intel's server processors of 2023). Where that has happened, and the processor can do
/// better, it is told so. Does nothing with another BLAS, or where the user has chosen the kernels
/// (OPENBLAS_CORETYPE).
/// Call once, first thing in `main`: it changes the environment for a moment, which no other thread
/// may look at meanwhile. Never fails.
void chooseBlasKernels();

/// One BLAS thread from now on: pieces are solved side by side already, and the same input gives
/// the same bits. Thread-safe.
void useOneBlasThread();

}  // namespace toile
