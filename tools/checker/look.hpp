#pragma once
/// \file
/// How much processor time a process has used. Time by the clock says little on a busy machine.

#include <sys/types.h>

namespace checker {

/// One look at a process.
struct Look {
    bool known = false;   ///< has the system told anything?
    double seconds = 0;   ///< of processor time, in all its threads
    bool asleep = false;  ///< none of its threads works, or would work if it had a processor
};

/// Looks at `process` and all its descendants.
Look look_at(pid_t process);

}  // namespace checker
