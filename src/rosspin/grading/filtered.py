"""Take from this process, for good, all of the kernel that a node does not need (seccomp, on Linux).

It can compute, have threads, wait, and use files that it may open. It cannot start or signal another process, open a
socket, mount, trace, make namespaces, or set up a terminal: for what is not in the list the kernel has no function,
as far as this process can see.
"""

from __future__ import annotations

import ctypes
import os
import struct
import sys

__all__ = ["close_kernel", "is_known"]

# Each with its number on x86_64 and on aarch64, where it has one.
_ALLOWED = """
read:0:63 write:1:64 readv:19:65 writev:20:66 pread64:17:67 pwrite64:18:68 close:3:57 fstat:5:80
newfstatat:262:79 statx:332:291 stat:4: lstat:6: lseek:8:62 mmap:9:222 munmap:11:215 mprotect:10:226
mremap:25:216 madvise:28:233 brk:12:214 msync:26:227 rt_sigaction:13:134 rt_sigprocmask:14:135
rt_sigreturn:15:139 rt_sigpending:127:136 rt_sigtimedwait:128:137 rt_sigsuspend:130:133 sigaltstack:131:132
access:21: faccessat:269:48 faccessat2:439:439 pipe:22: pipe2:293:59 select:23: pselect6:270:72 poll:7:
ppoll:271:73 epoll_create:213: epoll_create1:291:20 epoll_ctl:233:21 epoll_wait:232: epoll_pwait:281:22
eventfd2:290:19 sched_yield:24:124 dup:32:23 dup2:33: dup3:292:24 nanosleep:35:101
clock_nanosleep:230:115 getitimer:36:102 setitimer:38:103 alarm:37: pause:34: getpid:39:172 gettid:186:178
getppid:110:173 getuid:102:174 geteuid:107:175 getgid:104:176 getegid:108:177 getpgid:121:155 getpgrp:111:
getsid:124:156 getgroups:115:158 getresuid:118:148 getresgid:120:150 uname:63:160 umask:95:166 getcwd:79:17
chdir:80:49 fchdir:81:50 mkdir:83: mkdirat:258:34 rmdir:84: unlink:87: unlinkat:263:35 rename:82:
renameat:264:38 renameat2:316:276 link:86: linkat:265:37 symlink:88: symlinkat:266:36 readlink:89:
readlinkat:267:78 open:2: openat:257:56 creat:85: truncate:76:45 ftruncate:77:46 fsync:74:82 fdatasync:75:83
flock:73:32 getdents64:217:61 chmod:90: fchmod:91:52 fchmodat:268:53 utimensat:280:88 statfs:137:43
fstatfs:138:44 getrusage:98:165 times:100:153 sysinfo:99:179 gettimeofday:96:169 time:201: clock_gettime:228:113
clock_getres:229:114 getrandom:318:278 futex:202:98 set_robust_list:273:99 set_tid_address:218:96 rseq:334:293
restart_syscall:219:128 sched_getaffinity:204:123 getcpu:309:168 exit:60:93 exit_group:231:94 socketpair:53:199
sendto:44:206 recvfrom:45:207 sendmsg:46:211 recvmsg:47:212 shutdown:48:210 getsockopt:55:209 setsockopt:54:208
getsockname:51:204 getpeername:52:205 copy_file_range:326:285 sendfile:40:71 wait4:61:260 waitid:247:95
fadvise64:221:223 close_range:436:436 getrlimit:97:163
"""

# By processor: AUDIT_ARCH, and the column of the numbers.
_PROCESSORS = {"x86_64": (0xC000003E, 1), "aarch64": (0xC00000B7, 2)}

_PR_SET_SECCOMP, _PR_SET_NO_NEW_PRIVS = 22, 38
_FILTER = 2
_LOAD, _EQUAL, _ANY_BIT, _RETURN = 0x20, 0x15, 0x45, 0x06  # of BPF; each jump says how many lines it leaves out
_ALLOW, _NO_SUCH_FUNCTION, _END = 0x7FFF0000, 0x00050026, 0x80000000  # ENOSYS: the C library then tries another way
_NUMBER_AT, _ARCHITECTURE_AT, _ARGUMENTS_AT = 0, 4, 16  # in struct seccomp_data


def is_known() -> bool:
    """Whether there is a list for this system."""
    return sys.platform == "linux" and os.uname().machine in _PROCESSORS and sys.maxsize > 1 << 32


def close_kernel() -> None:
    """Close the kernel to this process, which has one thread; nothing opens it again. Raises OSError if that fails."""
    libc = ctypes.CDLL(None, use_errno=True)
    program = ctypes.create_string_buffer(_program())
    found = struct.pack("HP", len(program) // 8, ctypes.addressof(program))
    for option, value, data in ((_PR_SET_NO_NEW_PRIVS, 1, None), (_PR_SET_SECCOMP, _FILTER, found)):
        if libc.prctl(option, ctypes.c_ulong(value), data, 0, 0):
            raise OSError(ctypes.get_errno(), "the kernel cannot be closed to an answer")


def _program() -> bytes:
    """Return the filter in the kernel's language."""
    architecture, column = _PROCESSORS[os.uname().machine]
    lines = [_load(_ARCHITECTURE_AT), (_EQUAL, 1, 0, architecture), (_RETURN, 0, 0, _END), _load(_NUMBER_AT)]
    for name in _ALLOWED.split():
        if number := name.split(":")[column]:
            lines += [(_EQUAL, 0, 1, int(number)), (_RETURN, 0, 0, _ALLOW)]
    for numbers, argument, test, values in _allowed_with(os.getpid()):
        tests = [line for value in values for line in ((test, 0, 1, value), (_RETURN, 0, 0, _ALLOW))]
        lines += [(_EQUAL, 0, len(tests) + 2, numbers[column - 1]), _load(_ARGUMENTS_AT + 8 * argument), *tests]
        lines += [(_RETURN, 0, 0, _NO_SUCH_FUNCTION)]
    lines += [(_RETURN, 0, 0, _NO_SUCH_FUNCTION)]
    return b"".join(struct.pack("HBBI", *line) for line in lines)


def _allowed_with(pid: int) -> tuple[tuple[tuple[int, int], int, int, tuple[int, ...]], ...]:
    """Return what may be called with some values of an argument only: its numbers, which argument, and which values."""
    return (
        ((56, 220), 0, _ANY_BIT, (0x10000,)),  # clone: CLONE_THREAD
        ((62, 129), 0, _EQUAL, (pid,)),  # kill
        ((234, 131), 0, _EQUAL, (pid,)),  # tgkill
        ((302, 261), 0, _EQUAL, (0, pid)),  # prlimit64
        ((157, 167), 0, _EQUAL, (15, 16)),  # prctl: PR_SET_NAME, PR_GET_NAME
        ((16, 29), 1, _EQUAL, (0x5401, 0x5421, 0x541B, 0x5450, 0x5451)),  # ioctl: TCGETS, FIONBIO, FIONREAD, FIO(N)CLEX
        ((72, 25), 1, _EQUAL, (*range(8), 1030, 1032)),  # fcntl: F_DUPFD to F_SETLKW, F_DUPFD_CLOEXEC, F_GETPIPE_SZ
    )


def _load(offset: int) -> tuple[int, int, int, int]:
    return _LOAD, 0, 0, offset  # the lower half of a number: both processors are little-endian
