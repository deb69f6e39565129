#pragma once

namespace eod {

/// What a real box and a real bridge have by being alone: asks Linux to run the calling thread, and
/// those that it starts from now on, before the rest of the machine (nice -15). Does nothing where
/// the system forbids it (no CAP_SYS_NICE, no RLIMIT_NICE); then delays grow on a busy machine.
void RunBeforeOthers();

}  // namespace eod
