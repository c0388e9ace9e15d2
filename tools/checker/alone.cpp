#include "alone.hpp"

#include <cerrno>
#include <cstddef>

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace checker {

namespace {

#if defined(__x86_64__)
constexpr unsigned processor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned processor = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned processor = 0;
#endif

// Calls that came later do not exist: what they do nobody has looked at here. Nor do those of x32,
// the other way into an x86-64 kernel, whose numbers begin at 2^30.
constexpr unsigned newest = SYS_landlock_restrict_self;

// What C libraries do without when it does not exist. What clone3 and openat2 are to do cannot be
// seen from here, and io_uring does all the rest behind our back.
constexpr unsigned absent[] = {SYS_clone3, SYS_openat2, SYS_io_uring_setup, SYS_io_uring_enter, SYS_io_uring_register};

// arm64 came too late for the older half of these: there only the `…at` exist.
constexpr unsigned refused[] = {
// Processes.
#ifdef SYS_fork
    SYS_fork, SYS_vfork,
#endif
    // Reaching into other processes, and signals that go round the rule for kill.
    SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_process_madvise, SYS_kcmp, SYS_pidfd_open,
    SYS_pidfd_getfd, SYS_pidfd_send_signal, SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo, SYS_setpriority, SYS_ioprio_set,
    SYS_sched_setaffinity, SYS_sched_setattr, SYS_sched_setparam, SYS_sched_setscheduler, SYS_migrate_pages,
    SYS_move_pages,
    // Other roots and other namespaces, in which one may be another user.
    SYS_unshare, SYS_setns, SYS_chroot, SYS_pivot_root, SYS_mount, SYS_umount2, SYS_open_tree, SYS_move_mount,
    SYS_fsopen, SYS_fsconfig, SYS_fsmount, SYS_fspick,
    // The network, and an end of what goes to those who watch.
    SYS_socket, SYS_socketpair, SYS_shutdown,
    // Locks: others wait for them.
    SYS_flock,
    // Memory that outlives the process or is not counted as its own.
    SYS_shmget, SYS_shmat, SYS_shmctl, SYS_msgget, SYS_msgctl, SYS_semget, SYS_semctl, SYS_mq_open, SYS_mq_unlink,
    SYS_memfd_create, SYS_add_key, SYS_request_key, SYS_keyctl,
    // A pipe keeps what is moved into it so, whole huge pages for one byte.
    SYS_vmsplice, SYS_splice, SYS_tee,
    // What is for those who look into kernels.
    SYS_bpf, SYS_perf_event_open, SYS_userfaultfd};

// Making, changing and removing files: by these, and by opening them so.
constexpr unsigned of_files[] = {
#ifdef SYS_creat
    SYS_creat,
    SYS_unlink,
    SYS_rmdir,
    SYS_rename,
    SYS_link,
    SYS_symlink,
    SYS_mkdir,
    SYS_mknod,
    SYS_chmod,
    SYS_chown,
    SYS_lchown,
    SYS_utime,
    SYS_utimes,
    SYS_futimesat,
#endif
#ifdef SYS_renameat
    SYS_renameat,
#endif
    SYS_unlinkat,
    SYS_renameat2,
    SYS_linkat,
    SYS_symlinkat,
    SYS_mkdirat,
    SYS_mknodat,
    SYS_fchmod,
    SYS_fchmodat,
    SYS_fchown,
    SYS_fchownat,
    SYS_utimensat,
    SYS_truncate,
    SYS_setxattr,
    SYS_lsetxattr,
    SYS_fsetxattr,
    SYS_removexattr,
    SYS_lremovexattr,
    SYS_fremovexattr,
    SYS_open_by_handle_at};

// A call that depends on one argument.
struct Rule {
    unsigned call, argument;
    enum { one_of_the_bits, not_one_of_the_bits, equal, not_equal } refused_if;
    unsigned value;
};

constexpr unsigned writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;

constexpr Rule of_opening[] = {
#ifdef SYS_open
    {SYS_open, 1, Rule::one_of_the_bits, writing},
#endif
    {SYS_openat, 2, Rule::one_of_the_bits, writing}};

constexpr Rule by_argument[] = {
    {SYS_clone, 0, Rule::not_one_of_the_bits, CLONE_THREAD},
    {SYS_prlimit64, 0, Rule::not_equal, 0},           // of this process: getrlimit does that
    {SYS_prctl, 0, Rule::equal, PR_SET_PDEATHSIG},    // no way out of dying with the checker
    {SYS_prctl, 0, Rule::equal, PR_SET_THP_DISABLE},  // no huge pages: see become_worker.cpp
    {SYS_fcntl, 1, Rule::equal, F_SETPIPE_SZ},
    // Leases and locks: an editor that saves the file would wait for them.
    {SYS_fcntl, 1, Rule::equal, F_SETLEASE},
    {SYS_fcntl, 1, Rule::equal, F_SETLK},
    {SYS_fcntl, 1, Rule::equal, F_SETLKW},
    {SYS_fcntl, 1, Rule::equal, F_OFD_SETLK},
    {SYS_fcntl, 1, Rule::equal, F_OFD_SETLKW},
    // Signals to others when a file can be read.
    {SYS_fcntl, 1, Rule::equal, F_SETOWN},
    {SYS_fcntl, 1, Rule::equal, F_SETOWN_EX}};

// The rules in the language of the kernel's filter, which goes through them from top to bottom.
class Program {
public:
    std::vector<sock_filter> steps;

    void load(std::size_t offset) {
        steps.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset)));
    }
    // The next is done only where that holds of what was loaded, or only where it does not.
    void only_if(unsigned kind, unsigned number) { steps.push_back(BPF_JUMP(BPF_JMP | kind | BPF_K, number, 0, 1)); }
    void unless(unsigned kind, unsigned number) { steps.push_back(BPF_JUMP(BPF_JMP | kind | BPF_K, number, 1, 0)); }
    void end(unsigned how) { steps.push_back(BPF_STMT(BPF_RET | BPF_K, how)); }
    void fail(int error) { end(SECCOMP_RET_ERRNO | static_cast<unsigned>(error)); }

    void refuse(const Rule& rule) {
        load(offsetof(seccomp_data, nr));
        // Over the three steps below.
        steps.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, rule.call, 0, 3));
        // The lower half, which is all there is to a flag, a command or a process.
        load(offsetof(seccomp_data, args) + rule.argument * sizeof(__u64));
        const bool bits = rule.refused_if == Rule::one_of_the_bits || rule.refused_if == Rule::not_one_of_the_bits;
        if (rule.refused_if == Rule::one_of_the_bits || rule.refused_if == Rule::equal)
            only_if(bits ? BPF_JSET : BPF_JEQ, rule.value);
        else
            unless(bits ? BPF_JSET : BPF_JEQ, rule.value);
        fail(EPERM);
    }
};

}  // namespace

std::vector<sock_filter> rules(pid_t self, Files files) {
    if (processor == 0) return {};
    Program program;
    program.load(offsetof(seccomp_data, arch));  // 32-bit code has other numbers
    program.unless(BPF_JEQ, processor);
    program.fail(ENOSYS);
    program.load(offsetof(seccomp_data, nr));
    program.only_if(BPF_JGT, newest);
    program.fail(ENOSYS);
    for (const unsigned call : absent) {
        program.only_if(BPF_JEQ, call);
        program.fail(ENOSYS);
    }
    const auto refuse = [&](const auto& calls) {
        for (const unsigned call : calls) {
            program.only_if(BPF_JEQ, call);
            program.fail(EPERM);
        }
    };
    refuse(refused);
    if (files == Files::are_read) refuse(of_files);
    program.only_if(BPF_JEQ, SYS_ioctl);  // by which files are changed, and terminals typed into
    program.fail(ENOTTY);
    for (const Rule& rule : by_argument) program.refuse(rule);
    if (files == Files::are_read)
        for (const Rule& rule : of_opening) program.refuse(rule);
    if (self != 0)  // abort() sends itself a signal
        for (const unsigned call : {SYS_kill, SYS_tkill, SYS_tgkill})
            program.refuse({call, 0, Rule::not_equal, static_cast<unsigned>(self)});
    program.end(SECCOMP_RET_ALLOW);
    return program.steps;
}

void stay_alone(Files files) {
    // By these root reaches into any process and raises its limits. It may still read.
    for (unsigned right = 0; right <= CAP_LAST_CAP; ++right)
        if (right != CAP_DAC_READ_SEARCH) prctl(PR_CAPBSET_DROP, right);
    __user_cap_header_struct version{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct rights[2]{};
    if (syscall(SYS_capget, &version, rights) == 0) {
        for (auto& half : rights) half.inheritable = 0;
        syscall(SYS_capset, &version, rights);
    }
    std::vector<sock_filter> list = rules(getpid(), files);
    const sock_fprog program{static_cast<unsigned short>(list.size()), list.data()};
    if (!list.empty() && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

}  // namespace checker
