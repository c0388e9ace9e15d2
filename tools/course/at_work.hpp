#pragma once
/// \file
/// Does a program still work, or does it wait for what never comes?

#include <sys/types.h>

namespace course {

/// The processor time, in the system's ticks, that this process and all that come of it have taken so
/// far; -1 where one of them waits for a processor or a disk, or where the system tells nothing.
long work_of(pid_t process);

}  // namespace course
