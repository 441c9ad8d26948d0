"""Logs whose fault is known: which nodes make them, and what is true of them.

Those that begin with ``r1`` and ``r2`` were recorded on the real ROS 1 and ROS 2 by known_logs_recorded.py; those
that begin with ``s1`` and ``s2`` are made by a simulated run whenever a test asks for them.
"""

from __future__ import annotations

from dataclasses import dataclass
from hashlib import sha256
from random import Random
from typing import Any

# Verdicts that are true of a fault but leave open which of two it is; each names this one in its evidence.
OPEN = {
    "clock": "held-up",
    "overran": "held-up",
    "publishers": "doubled",
    "stalled": "held-up",
    "twins": "doubled",
}


@dataclass(frozen=True)
class Case:
    """A log: its nodes by their command lines, and the verdicts that are true of it.

    ``after``: when each node starts (s). ``stops``: when all processes are stopped and for how long (s). ``jumps``:
    when their clocks are set, and by how much (s). ``form``: what the log is, and how it is dressed.
    """

    name: str
    truth: str
    nodes: tuple[str, ...]
    seconds: float = 10.0
    after: tuple[float, ...] = ()
    stops: tuple[tuple[float, float], ...] = ()
    jumps: tuple[tuple[float, float], ...] = ()
    form: str = "console"

    def outcome(self, verdict: str) -> str:
        """Whether a verdict is right, leaves it open, says that it cannot tell, or is wrong."""
        if verdict in (self.truth, "unknown"):
            return "right" if verdict == self.truth else "unknown"
        return "open" if verdict == OPEN.get(self.truth) else "wrong"

    @property
    def ros(self) -> int:
        return int(self.name[1])

    @property
    def is_real(self) -> bool:
        return self.name[0] == "r"

    @property
    def is_held_out(self) -> bool:
        """Whether what is said of it was unknown when this was written: fixed by its name, before."""
        return sha256(self.name.encode()).digest()[0] % 2 == 1


REAL = [
    # As it should be.
    Case("r2_timer_10", "healthy", ("motor timer,wheel_speed,10",)),
    Case("r2_timers_5_50", "healthy", ("base timer,odometry,50 timer,battery,5",)),
    Case("r2_rate_20", "healthy", ("arm rate,joint_state,20",), 8),
    Case("r2_three_nodes", "healthy", ("motor timer,wheel_speed,10", "arm timer,joint_state,20", "eye timer,frame,4")),
    Case("r2_timer_100", "healthy", ("imu timer,imu,100,work=0.002",), 5),
    Case("r2_pub_sub", "healthy", ("compass pub,sent_heading,10", "pilot sub,heard_heading,0"), 10),
    Case("r1_timer_10", "healthy", ("motor timer,wheel_speed,10",)),
    Case("r1_rate_50", "healthy", ("arm rate,joint_state,50,work=0.003",), 6),
    Case("r1_two_nodes", "healthy", ("motor timer,wheel_speed,10", "eye timer,frame,4")),
    Case("r1_echo_10", "healthy", ("compass pub,sent,10",), 8, form="echo"),
    Case("r1_bag_20", "healthy", ("compass pub,sent,20",), 6, form="bag"),
    # A sleep of fixed length after work.
    Case("r2_sleep_10_work_5", "sleep", ("motor sleep,wheel_speed,10,work=0.005",)),
    Case("r2_sleep_30_work_varies", "sleep", ("arm sleep,joint_state,30,work=0.002,spread=0.004",), 8),
    Case("r2_sleep_2_work_70", "sleep", ("eye sleep,frame,2,work=0.07",), 14),
    Case("r2_sleep_beside_timer", "sleep", ("base sleep,odometry,20,work=0.008", "motor timer,wheel_speed,10")),
    Case("r1_sleep_10_work_20", "sleep", ("motor sleep,wheel_speed,10,work=0.02",)),
    Case("r1_sleep_5_work_varies", "sleep", ("eye sleep,frame,5,work=0.03,spread=0.04",), 12),
    Case("r1_sleep_50_work_4", "sleep", ("arm sleep,joint_state,50,work=0.004",), 6),
    # In bursts.
    Case("r2_bursts", "bursts", ("driver burst,scan,2,size=5",)),
    # A pass that took too long.
    Case("r2_overran_beside", "overran", ("motor timer,wheel_speed,10,at=30,slow=0.35", "arm timer,joint_state,20")),
    Case("r2_overran_alone", "overran", ("motor timer,wheel_speed,20,at=70,slow=0.22",), 8),
    Case("r2_overran_each_10th", "overran", ("motor timer,wheel_speed,10,every=10,slow=0.25", "eye timer,frame,5"), 12),
    Case("r2_overran_rate", "overran", ("arm rate,joint_state,25,at=60,slow=0.5", "eye timer,frame,8"), 8),
    Case("r1_overran_rate_alone", "overran", ("arm rate,joint_state,10,at=40,slow=0.35",)),
    Case("r1_overran_timer_beside", "overran", ("motor timer,wheel_speed,20,at=50,slow=0.4", "eye timer,frame,10"), 8),
    Case("r1_overran_each_8th", "overran", ("motor timer,wheel_speed,10,every=8,slow=0.16", "eye timer,frame,7"), 12),
    # A slow callback that blocks its neighbours.
    Case("r2_blocks_one", "blocked", ("base timer,odometry,20 timer,plan,1,work=0.3", "motor timer,wheel_speed,10")),
    Case("r2_blocks_two", "blocked", ("base timer,odometry,25 timer,battery,10 timer,map,0.7,work=0.4",), 14),
    Case("r2_blocks_by_sub", "blocked", ("base timer,odometry,50 sub,image,0,work=0.15", "eye pub,sent,2"), 10),
    Case("r1_blocks_by_lock", "blocked", ("base timer,odometry,20,lock=1 timer,plan,1,work=0.3,lock=1",), 10),
    Case(
        "r1_blocks_by_lock_beside",
        "blocked",
        ("base timer,odometry,10,lock=1 timer,plan,0.8,work=0.5,lock=1", "eye timer,frame,8"),
        14,
    ),
    # A subscriber behind a full queue.
    Case("r2_queue_both_log", "queue", ("compass pub,sent_heading,20", "pilot sub,heard_heading,0,work=0.1,queue=10")),
    Case(
        "r2_queue_sub_logs", "queue", ("compass pub,x,10,silent=1", "pilot sub,heard_heading,0,work=0.25,queue=5"), 14
    ),
    Case(
        "r1_queue_both_log",
        "queue",
        ("compass pub,sent_heading,20", "pilot sub,heard_heading,0,work=0.2,queue=5"),
        12,
    ),
    Case(
        "r1_queue_sub_logs", "queue", ("compass pub,x,30,silent=1", "pilot sub,heard_heading,0,work=0.09,queue=3"), 10
    ),
    # All late together.
    Case("r2_stopped", "stalled", ("motor timer,wheel_speed,10", "arm timer,joint_state,25"), 10, stops=((5, 0.8),)),
    Case(
        "r2_stopped_thrice",
        "stalled",
        ("motor timer,wheel_speed,10", "arm timer,joint_state,20", "eye rate,frame,5"),
        12,
        stops=((3, 0.5), (6.2, 0.7), (9.1, 0.45)),
    ),
    Case("r2_stopped_alone", "stalled", ("motor timer,wheel_speed,10",), 8, stops=((4, 0.75),)),
    Case("r2_garbage", "stalled", ("base --threads timer,odometry,40 rate,battery,15 gc,x,0.5,objects=2500000",), 14),
    Case("r1_stopped", "stalled", ("motor timer,wheel_speed,10", "arm rate,joint_state,30"), 9, stops=((4.5, 1.1),)),
    Case("r1_garbage", "stalled", ("base timer,odometry,25 timer,battery,10 gc,x,0.4,objects=3000000",), 14),
    # The clock was set. Timers of rclpy go by that clock: if it is set back, they wait, and nothing shows.
    Case(
        "r2_clock_forward",
        "clock",
        ("motor timer,wheel_speed,10", "arm timer,joint_state,20"),
        10,
        jumps=((5, 3.217),),
    ),
    Case("r2_clock_back", "clock", ("motor sleep,wheel_speed,10",), 10, jumps=((5, -2.35),)),
    Case("r2_clock_back_two", "clock", ("motor sleep,wheel_speed,20", "eye timer,frame,4"), 9, jumps=((5, -0.63),)),
    Case("r1_clock_back", "clock", ("motor timer,wheel_speed,10", "eye timer,frame,5"), 10, jumps=((5, -1.4),)),
    # Another publisher on the topic.
    Case(
        "r2_second_publisher",
        "publishers",
        ("compass pub,x,10,silent=1", "old_compass pub,x,10,silent=1", "pilot sub,heard_heading,0"),
        10,
        after=(0, 1.33, 0),
    ),
    Case(
        "r2_second_publisher_slower",
        "publishers",
        ("compass pub,x,10,silent=1,first=500", "old_compass pub,x,4,silent=1", "pilot sub,heard_heading,0"),
        10,
    ),
    Case("r1_second_publisher_echo", "publishers", ("one pub,x,10", "two pub,x,10"), 9, after=(0, 1.72), form="echo"),
    Case("r1_second_publisher_bag", "publishers", ("one pub,x,20", "two pub,x,5"), 8, after=(0, 2.1), form="bag"),
    # Two nodes of one name.
    Case("r2_twins", "twins", ("motor timer,wheel_speed,10", "motor timer,wheel_speed,10"), 10, after=(0, 0.73)),
    Case("r2_twins_later", "twins", ("arm timer,joint_state,20", "arm timer,joint_state,20"), 12, after=(0, 4.31)),
    Case("r2_twins_two_lines", "twins", ("base timer,odometry,10 timer,battery,3",) * 2, 12, after=(0, 2.57)),
    Case("r1_twins", "twins", ("motor timer,wheel_speed,10", "motor timer,wheel_speed,10"), 10, after=(0, 4)),
    # Not regular.
    Case("r2_events", "unknown", ("door event,bump,3",), 12),
    Case("r1_events", "unknown", ("door event,bump,5",), 10),
]

J = ",jitter=0.0004"  # of a quiet machine
B = ",jitter=0.0015"  # of a busy one
SIMULATED = [
    Case("s2_timer_1", "healthy", (f"clock timer,second,1{J}",), 40),
    Case("s2_timer_30", "healthy", (f"eye timer,frame,30{B}",), 20),
    Case("s2_timer_7", "healthy", (f"arm timer,joint_state,7{J}", f"eye timer,frame,15{J}"), 20, form="launch"),
    Case("s2_callback_takes_half", "healthy", (f"base timer,odometry,10,work=0.03{J} timer,battery,2{J}",), 20),
    Case("s2_timer_100_busy", "healthy", (f"imu timer,imu,100{J}",), 6, form="colours"),
    Case("s2_csv_25", "healthy", (f"eye timer,frame,25{J}",), 12, form="csv"),
    Case("s1_rate_4", "healthy", (f"arm rate,joint_state,4,work=0.1,spread=0.1{J}",), 30),
    Case("s1_timers", "healthy", (f"base timer,odometry,20{J} timer,battery,1{J} timer,map,3{J}",), 20, form="pasted"),
    Case("s1_rate_12", "healthy", (f"arm rate,joint_state,12{B}",), 20, form="files"),
    Case("s2_bursts", "bursts", (f"driver burst,scan,4,size=3{J}",), 12, form="launch"),
    Case("s1_bursts_vary", "bursts", (f"driver burst,scan,1,size=8,fewer=4{J}",), 20, form="pasted"),
    Case("s1_bursts_long", "bursts", ("driver burst,scan,1,size=4,work=0.02", f"eye timer,frame,8{J}"), 20),
    Case("s2_sleep_1", "sleep", (f"clock sleep,second,1,work=0.05,spread=0.02{J}",), 60),
    Case("s2_sleep_50", "sleep", (f"imu sleep,imu,50,work=0.003,spread=0.001{J}",), 10, form="launch"),
    Case("s2_sleep_20_two", "sleep", (f"a sleep,left,20,work=0.01{J}", f"b sleep,right,20,work=0.012{J}"), 20),
    Case("s2_always_slow", "sleep", (f"base timer,odometry,10,work=0.13,spread=0.01{J}",), 25, form="colours"),
    Case("s1_sleep_4", "sleep", (f"eye sleep,frame,4,work=0.06,spread=0.1{J}",), 30, form="pasted"),
    Case("s1_rate_too_slow", "sleep", (f"arm rate,joint_state,20,work=0.055,spread=0.02{J}",), 15),
    Case(
        "s2_overran_launch",
        "overran",
        (f"a timer,left,10,at=40,slow=0.5{J}", f"b timer,right,10{J}"),
        15,
        form="launch",
    ),
    Case("s2_overran_each_20", "overran", (f"base timer,odometry,20,every=20,slow=0.12{B}",), 20),
    Case("s2_overran_twice", "overran", (f"base timer,odometry,10,every=60,slow=0.33{J}", f"eye rate,frame,15{J}"), 18),
    Case("s1_overran_beside", "overran", (f"base rate,odometry,10,at=33,slow=0.6{J} timer,battery,8{J}",), 12),
    Case("s1_overran_each_5", "overran", (f"base rate,odometry,25,every=5,slow=0.09{J} timer,battery,10{J}",), 12),
    Case("s2_blocks_by_rare", "blocked", (f"base timer,odometry,30{J} timer,map,0.25,work=0.5",), 40),
    Case(
        "s2_blocks_by_sub", "blocked", (f"base timer,odometry,20{J} sub,image,0,work=0.2", f"eye pub,sent,0.8{J}"), 25
    ),
    Case("s2_blocks_each_8th", "blocked", (f"base timer,odometry,10,every=8,slow=0.35{J} timer,battery,25{J}",), 25),
    Case("s1_blocks_by_lock", "blocked", (f"base timer,odometry,15,lock=1{J} timer,map,0.5,work=0.4,lock=1",), 30),
    Case("s2_queue_small", "queue", ("compass pub,x,30,silent=1", f"pilot sub,heard,0,work=0.05,queue=2{J}"), 12),
    Case(
        "s2_queue_both",
        "queue",
        (f"compass pub,sent,10{J}", f"pilot sub,heard,0,work=0.16,spread=0.03,queue=8{J}"),
        20,
    ),
    Case(
        "s1_queue",
        "queue",
        ("compass pub,x,50,silent=1", f"pilot sub,heard,0,work=0.03,queue=4{J}"),
        12,
        form="colours",
    ),
    Case(
        "s2_stalled",
        "stalled",
        (f"a timer,left,10{J}", f"b timer,right,15{J}", f"c timer,up,4{J}"),
        15,
        stops=((7.03, 0.9),),
    ),
    Case(
        "s2_stalled_often",
        "stalled",
        (f"a timer,left,20{J}", f"b timer,right,30{J}"),
        20,
        stops=((4, 0.4), (9, 0.5), (16, 0.35)),
    ),
    Case("s2_stalled_one_node", "stalled", (f"base timer,odometry,20{J} timer,battery,9{J}",), 15, stops=((6.3, 0.6),)),
    Case("s2_clock_forward", "clock", (f"a timer,left,10{J}", f"b timer,right,4{J}"), 15, jumps=((6.2, 7.77),)),
    Case("s2_clock_back", "clock", (f"base sleep,odometry,25,work=0.001{J}",), 12, jumps=((5.1, -3.3),)),
    Case("s1_clock_back_hour", "clock", (f"arm rate,joint_state,5{J}",), 15, jumps=((5.1, -3600.2),)),
    Case("s1_clock_forward", "clock", (f"arm rate,joint_state,5{J} timer,battery,3{J}",), 18, jumps=((8.1, 1800.35),)),
    Case(
        "s2_second_publisher_csv",
        "publishers",
        (f"a pub,x,10{J}", f"b pub,x,10{J}"),
        12,
        after=(0, 0.037),
        form="csv",
    ),
    Case(
        "s2_second_publisher_beat",
        "publishers",
        ("a pub,x,8,silent=1", "b pub,x,5,silent=1", f"c sub,data,0{J} timer,beat,2{J}"),
        14,
        after=(0, 1.03, 0),
    ),
    Case(
        "s1_second_publisher",
        "publishers",
        ("a pub,x,10,silent=1", "b pub,x,10,silent=1,first=70", f"c sub,I_heard,0{J}"),
        14,
        after=(0, 0.046, 0),
    ),
    Case(
        "s2_twins_launch",
        "twins",
        (f"base timer,odometry,10{J}", f"base timer,odometry,10{J}"),
        12,
        after=(0, 0.41),
        form="launch",
    ),
    Case("s2_twins_two_lines", "twins", (f"base timer,odometry,10{J} timer,battery,3{J}",) * 2, 14, after=(0, 2.57)),
    Case("s2_lost_tenth", "lost", (f"pilot timer,heard,20{J}",), 20, form="lossy"),
    Case("s1_lost_tenth", "lost", (f"pilot timer,I_heard,8{B}", f"base timer,odometry,10{J}"), 30, form="lossy"),
    Case("s2_events", "unknown", ("door event,bump,4",), 25),
    Case("s1_events_two", "unknown", ("door event,bump,2", "bell event,ring,1"), 30),
    Case("s2_few_lines", "unknown", ("door timer,open,0.4",), 10),
]
CASES = [*REAL, *SIMULATED]


def draw(seed: int) -> Case:
    """A simulated log with a fault, its rates, lengths, jitter and form drawn at random."""
    pick = Random(seed)
    ros = pick.choice((1, 2))
    jitter = f",jitter={pick.choice((0.0001, 0.0004, 0.001)):g}"
    rate, other = pick.sample((2, 4, 5, 7, 8, 10, 12, 15, 20, 24, 25, 30, 40, 50), 2)
    rate = max(rate, 4)
    seconds = max(10.0, 60 / min(rate, other)) + pick.uniform(0, 10)
    form = pick.choice(("console", "colours", "pasted", "console"))
    beside = f"eye timer,frame,{other}{jitter}"
    late = round(pick.uniform(0.3, 0.7) * seconds, 3)
    truth = pick.choice(("healthy", "sleep", "overran", "blocked", "queue", "stalled", "clock", "publishers", "twins"))
    if ros == 1 and truth in (
        "stalled",
        "twins",
    ):  # of which its console says nothing, or a node cannot be such a one
        ros = 2
    more: dict[str, Any] = {}
    if truth == "healthy":
        kind = pick.choice(("timer", "rate"))
        nodes = (f"base {kind},odometry,{rate},work={pick.uniform(0, 0.6) / rate:.4f}{jitter}", beside)[
            : pick.choice((1, 2))
        ]
    elif truth == "sleep":
        work = pick.uniform(0.05, 0.45) / rate
        nodes = (f"base sleep,odometry,{rate},work={work:.4f},spread={0.3 * work:.4f}{jitter}", beside)[
            : pick.choice((1, 2))
        ]
    elif truth == "overran":
        when = pick.choice((f"at={int(late * rate)}", f"every={pick.randint(6, 20)}"))
        nodes = (
            f"base {pick.choice(('timer', 'rate'))},odometry,{rate},{when},slow={pick.uniform(1.6, 5) / rate:.3f}"
            f"{jitter}",
            beside,
        )
    elif truth == "blocked":
        lock = ",lock=1" if ros == 1 else ""
        slow = pick.uniform(3.3, 6)
        rate = max(rate, 8)
        seconds = max(seconds, 5 * slow)
        nodes = (
            f"base timer,odometry,{rate}{lock}{jitter} "
            f"timer,map,{1 / slow:.3f},work={pick.uniform(2.5, 7) / rate:.3f}{lock}",
            beside,
        )
        nodes = nodes[: pick.choice((1, 2))]
    elif truth == "queue":
        work = pick.uniform(1.3, 3.5) / rate
        nodes = (
            f"compass pub,sent,{rate},silent={pick.choice((0, 1))}",
            f"pilot sub,heard,0,work={work:.4f},queue={pick.randint(1, 10)}{jitter}",
        )
        seconds = max(seconds, 100 / rate)
    elif truth == "stalled":
        nodes = (f"base timer,odometry,{rate}{jitter}", beside)
        more = {"stops": ((late, round(pick.uniform(3, 8) / min(rate, other), 3)),)}
    elif truth == "clock":
        kind = "timer" if ros == 1 else "sleep"
        nodes = (f"base {kind},odometry,{rate}{jitter}", beside)
        more = {"jumps": ((late, pick.choice((-1, 1)) * round(pick.uniform(1, 100), 3)),)}
    elif truth == "publishers":
        nodes = (
            f"a pub,x,{rate},silent=1",
            f"b pub,x,{pick.choice((rate, other))},silent=1",
            f"c sub,heard,0{jitter}",
        )
        more = {"after": (0.0, round(pick.uniform(0.01, 2), 3), 0.0)}
    else:
        nodes = (f"base timer,odometry,{rate}{jitter}",) * 2
        more = {"after": (0.0, round(pick.uniform(0.01, 3), 3))}
        form = pick.choice(("console", "launch"))
    return Case(f"s{ros}_drawn_{seed}", truth, nodes, round(seconds, 2), form=form, **more)
