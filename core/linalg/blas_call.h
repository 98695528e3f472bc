// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace toile::linalg {

/// While it lives so many threads at a time may call the BLAS as there is room for. OpenBLAS takes
/// a working buffer for each thread that calls it, keeps it for later, and where the process may
/// have no more memory (`ulimit -v`, RLIMIT_DATA) tries again for ever: so the buffers are taken
/// here, before anybody calls, and before the threads are started whose stacks would take their
/// place. Thread-safe.
class BlasCall {
public:
    /// @param threads  that would like to call; at least 1
    explicit BlasCall(int threads = 1);
    ~BlasCall();
    BlasCall(const BlasCall&) = delete;
    BlasCall& operator=(const BlasCall&) = delete;

    /// How many of them may, from 0.
    int room() const { return room_; }

private:
    int room_ = 0;
};

/// From here on OpenBLAS works on the thread that calls it alone, in this process and in those that
/// it forks: pieces are solved side by side already, and the same input gives the same bits. One
/// that is forked before starts OpenBLAS's threads anew for it. Thread-safe.
void useOneBlasThread();

}  // namespace toile::linalg
