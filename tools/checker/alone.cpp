#include "alone.hpp"

#include <cerrno>
#include <cstddef>
#include <iterator>

#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace checker {

namespace {

constexpr sock_filter load(std::size_t offset) {
    return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset));
}
// The next is done only where it is that number, or has that bit.
constexpr sock_filter only_if(unsigned kind, unsigned number) {
    return BPF_JUMP(BPF_JMP | kind | BPF_K, number, 0, 1);
}
constexpr sock_filter end(unsigned how) {
    return BPF_STMT(BPF_RET | BPF_K, how);
}

}  // namespace

void start_no_processes() {
    const unsigned refuse = SECCOMP_RET_ERRNO | EPERM;
    const auto self = static_cast<unsigned>(getpid());  // abort() sends itself a signal
    // What clone3 is to do cannot be seen from here; without it the C library uses clone.
    sock_filter rules[] = {
        load(offsetof(seccomp_data, nr)),
        only_if(BPF_JEQ, SYS_clone3),
        end(SECCOMP_RET_ERRNO | ENOSYS),
#ifdef SYS_fork
        only_if(BPF_JEQ, SYS_fork),
        end(refuse),
        only_if(BPF_JEQ, SYS_vfork),
        end(refuse),
#endif
        // No signals to others, who would take the checker's place, and no way out of dying with it.
        only_if(BPF_JEQ, SYS_ptrace),
        end(refuse),
        only_if(BPF_JEQ, SYS_pidfd_send_signal),
        end(refuse),
        only_if(BPF_JEQ, SYS_prctl),
        BPF_JUMP(BPF_JMP | BPF_JA, 8, 0, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_kill, 3, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_tkill, 2, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_tgkill, 1, 0),
        BPF_JUMP(BPF_JMP | BPF_JA, 8, 0, 0),
        load(offsetof(seccomp_data, args)),  // to whom
        only_if(BPF_JEQ, self),
        end(SECCOMP_RET_ALLOW),
        end(refuse),
        load(offsetof(seccomp_data, args)),  // what prctl is to do
        only_if(BPF_JEQ, PR_SET_PDEATHSIG),
        end(refuse),
        end(SECCOMP_RET_ALLOW),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone, 1, 0),
        end(SECCOMP_RET_ALLOW),
        load(offsetof(seccomp_data, args)),  // the flags
        only_if(BPF_JSET, CLONE_THREAD),
        end(SECCOMP_RET_ALLOW),
        end(refuse),
    };
    const sock_fprog program{static_cast<unsigned short>(std::size(rules)), rules};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

}  // namespace checker
