#pragma once
/// \file
/// A process that starts no other.

namespace checker {

/// From here on this process and the programs it becomes may start threads, but no processes:
/// `fork` fails. So there is nothing left of it when it has ended. Where the system cannot do that
/// all stays as it is.
void start_no_processes();

}  // namespace checker
