#include "platform/priority.h"

#include <sys/resource.h>

namespace eod {

// On Linux, process 0 is the calling thread alone.
void RunBeforeOthers() { setpriority(PRIO_PROCESS, 0, -15); }

}  // namespace eod
