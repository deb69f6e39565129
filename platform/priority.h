#pragma once

namespace eod {

/// What a real box and a real bridge have by being alone: asks Linux to run the calling thread, and
/// those that it starts from now on, before the rest of the machine: real-time scheduling
/// (SCHED_FIFO, priority 10), or nice -15 where that is forbidden. Does nothing where that is
/// forbidden too (README, "plugging in a real box"); then delays grow on a busy machine. Not for
/// work that fills a processor.
void RunBeforeOthers();

/// The contrary, for the calling thread and those that it starts from now on: runs when the rest of
/// the program leaves the processor free (nice 5).
void RunAfterOthers();

}  // namespace eod
