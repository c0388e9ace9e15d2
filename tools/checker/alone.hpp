#pragma once
/// \file
/// What a process may not do that holds a stranger's code.

#include <vector>

#include <linux/filter.h>
#include <sys/types.h>

namespace checker {

/// What a process may do with files: valgrind needs some of its own.
enum class Files { are_read, are_written_too };

/// The rules for the system calls of a process and of the programs it becomes: it may print, take
/// memory, start threads, read files and look at the clock. It may not start processes, change
/// anything in the file system, lock a file, reach other processes or the network. Signals go to
/// `self` alone; with none, to all it sees, for a process that is alone in its PID namespace. Empty
/// where the processor is not known here.
std::vector<sock_filter> rules(pid_t self = 0, Files files = Files::are_read);

/// From here on this process keeps the rules, and has no rights that a user has not. So there is
/// nothing left of it when it has ended. Where the system cannot do that all stays as it is.
void stay_alone(Files files);

}  // namespace checker
