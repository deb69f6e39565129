#include "platform/priority.h"

#include <sched.h>
#include <sys/resource.h>

namespace eod {

// On Linux, process 0 is the calling thread alone.

void RunBeforeOthers() {
  const sched_param priority{.sched_priority = 10};
  if (sched_setscheduler(0, SCHED_FIFO, &priority) != 0) setpriority(PRIO_PROCESS, 0, -15);
}

void RunAfterOthers() {
  const sched_param none{.sched_priority = 0};
  sched_setscheduler(0, SCHED_OTHER, &none);
  setpriority(PRIO_PROCESS, 0, 5);
}

}  // namespace eod
