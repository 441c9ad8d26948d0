"""Judge what a vehicle did that runs together with an answer, which steers it; and the driver that tasks begin with."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from ..vehicle.drives import OTHERS, STILL, Command, Spot, say_off
from ..vehicle.physics import EDGE, FASTEST, Place, Vehicle
from .feedback import Finding
from .judges import CLOSE, ONCE
from .judging import plain, say
from .observed import ObservedRun

__all__ = [
    "TURNS",
    "between",
    "commands",
    "driver_cpp",
    "follows",
    "is_rare",
    "one_publisher",
    "stands",
    "steady",
    "unmoved",
]

TURNS = "The commands come often enough. Is the turn 8.0 times the newest offset, as before?"
"""The hint for an answer that steers often enough, and not well."""

_LEAST = 0.9  # of the way that it can go, it has to go so much
_LONGEST = 0.35  # s; commands that come as rarely as this lose the line
_OWN = ("/rosout", "/parameter_events")  # of every node

_DRIVER_CPP = """
#include <chrono>
#include <memory>

#include "geometry_msgs/msg/twist.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float32.hpp"

using namespace std::chrono_literals;

class DriverCppNode : public rclcpp::Node
{
public:
  DriverCppNode() : Node("driver_cpp_node")
  {
    publisher_ = create_publisher<geometry_msgs::msg::Twist>("cmd_vel", 10);
    subscription_ = create_subscription<std_msgs::msg::Float32>("line", 10,
        [this](const std_msgs::msg::Float32& message) { lineCallback(message); });
    timer_ = create_wall_timer(PERIOD, [this] { timerCallback(); });
  }

private:
  void lineCallback(const std_msgs::msg::Float32& message)
  {
    offset_ = message.data;
  }

  void timerCallback()
  {
    geometry_msgs::msg::Twist command;
    command.linear.x = 2.0;  // m/s
    command.angular.z = 8.0 * offset_;  // rad/s, to the left
    publisher_->publish(command);
  }

  rclcpp::Publisher<geometry_msgs::msg::Twist>::SharedPtr publisher_;
  rclcpp::Subscription<std_msgs::msg::Float32>::SharedPtr subscription_;
  rclcpp::TimerBase::SharedPtr timer_;
  double offset_ = 0.0;
};

int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<DriverCppNode>());
  rclcpp::shutdown();
  return 0;
}
"""


def driver_cpp(period: str) -> str:
    """Return a node in C++ that steers by a timer of this period, such as ``100ms``."""
    return _DRIVER_CPP.replace("PERIOD", period)


def commands(run: ObservedRun, first: float = 0.0, last: float = float("inf")) -> list[Command]:
    """Return the commands of the answer from one time (s) to another, without what other nodes sent."""
    return [each for each in run.drive.commands if each.node not in OTHERS and first <= each.time <= last]


def between(run: ObservedRun) -> float:
    """Return the mean time (s) from one command of the answer to the next, or to the end if there are not two."""
    times = [command.time for command in commands(run)]
    return round((times[-1] - times[0]) / (len(times) - 1), 3) if len(times) > 1 else run.seconds


def is_rare(run: ObservedRun) -> bool:
    """Whether the answer sent nothing for a while that is too long to keep to the line."""
    times = [command.time for command in commands(run)]
    return any(after - time > _LONGEST for time, after in pairwise([*times, run.seconds]))


def steady(run: ObservedRun, period: float, loops: Sequence[int] = ()) -> Iterator[Finding]:
    """Find out whether commands come one each period (s), sent by one timer with one publisher.

    ``loops`` are the lines in which a loop may send them.
    """
    times = [command.time for command in commands(run)]
    if wrong := one_publisher(run):
        yield wrong
    if sum(after - time < CLOSE for time, after in pairwise(times)) > len(times) / 3:
        text = f"{len(times)} commands came in {say(run.seconds)}, two at a time."
        yield Finding(False, text, "Do two timers send them, or does one call of the callback send two?")
        return
    if wrong := _from_no_timer(run, len(times), loops):
        yield wrong
    text = f"{len(times)} commands came in {say(run.seconds)}, one every {say(between(run))}."
    hint = f"{1 / period:.10g} times a second is one every {say(period)}, from one timer."
    yield Finding(abs(between(run) - period) < 0.1 * period, text, hint)


def one_publisher(run: ObservedRun) -> Finding | None:
    """Find out whether the answer made several publishers of commands; None if one was enough."""
    made = len(run.endpoints_of("/cmd_vel", True))
    if made < 2:
        return None
    return Finding(False, f"the node made {made} publishers of `/cmd_vel`, where one would do.", ONCE)


def _from_no_timer(run: ObservedRun, sent: int, loops: Sequence[int]) -> Finding | None:
    """Find out what else than one timer sends the commands; None if nothing does."""
    calls = [len(timer.calls) for timer in run.timers]
    if any(timer.state == "running" and len(timer.calls) >= 0.5 * sent for timer in run.timers):
        return None
    if loops:
        hint = "Let a timer do that: the node calls it between the other callbacks, and ends it."
        return Finding(False, f"no timer of the node sends the commands: a loop does, at line {loops[0]}.", hint)
    if sum(calls) >= 0.9 * sent and len(calls) > 2:
        hint = "One timer calls back again by itself: make it once, where the node is made."
        return Finding(False, f"{len(calls)} timers sent the commands, one after the other.", hint)
    hint = "If the sensor falls silent, so do the commands. With a timer the node acts at times of its own."
    if any(calls):
        hint = "Something else sends commands, too, such as the sensor's callback. Let only the timer send them."
        return Finding(False, "not all of the commands are sent by a timer of the node.", hint)
    return Finding(False, "no timer of the node sends the commands.", hint)


def unmoved(run: ObservedRun) -> Finding | None:
    """Find out why the vehicle was sent nothing that moves it; None if it was."""
    sent = commands(run)
    if any(command.speed for command in sent):
        if _way(run.drive.spots) > STILL:
            return None
        text = f"a command came on `/cmd_vel`, at {say(sent[0].time)}, but it did not reach the vehicle."
        types = {plain(each.type) for each in run.sent if each.topic == "/cmd_vel"}
        hint = "Messages published before the nodes find each other are lost: publish from a timer, again and again."
        if any(endpoint.refused for endpoint in run.endpoints_of("/cmd_vel", True)):
            hint = "The publisher offers less than the vehicle asks for: read the warnings. `10` is enough."
        if not any(name.endswith("Twist") for name in types):
            hint = f"The vehicle takes messages of the type `Twist`, and these are of another one: {', '.join(types)}."
        return Finding(False, text, hint)
    if sent:
        text = f"each of {len(sent)} commands has a speed of 0: the vehicle never moved."
        return Finding(False, text, "`command.linear.x = 2.0`: a new `Twist` is all zeros.")
    text = "no command came on `/cmd_vel`: the vehicle never moved."
    endpoints = run.endpoints_of("/cmd_vel", True)
    slow = [timer.period for timer in run.timers if not timer.calls and timer.period > run.seconds]
    if endpoints and slow:
        hint = f"The timer's period is {say(slow[0])}: its first call is not due before the run ends, at"
        return Finding(False, text, f"{hint} {say(run.seconds)}.")
    if endpoints and run.timers and not any(timer.calls for timer in run.timers):
        hint = "A timer of the node was never called. Does the executor that spins have the node: `add_node(...)`?"
        return Finding(False, text, hint)
    if endpoints:
        return Finding(False, text, "There is a publisher. Does a timer publish with it, again and again?")
    others = [each.topic for each in run.endpoints if each.publishes and each.topic not in _OWN]
    where = f"It publishes on `{plain(others[0])}`. " if others else ""
    return Finding(False, text, f"{where}The vehicle listens to `cmd_vel`.")


def follows(
    run: ObservedRun, hint: str = "", first: float = 0.0, last: float = float("inf"), speed: float = FASTEST
) -> Finding:
    """Whether the vehicle drives at its ``speed`` (m/s) from one time (s) to another, and keeps to its line.

    ``hint`` is for whoever steers it well, but too late.
    """
    if wrong := unmoved(run):
        return wrong
    when = f"up to {say(last)} " if last < run.seconds else f"from {say(first)} on " if first else ""
    spots = [spot for spot in run.drive.spots if first <= spot.time <= last]
    sent = [command for command in commands(run, first, last) if command.speed]
    if not sent:
        return Finding(False, f"from {say(first)} on no command moved the vehicle.", hint)
    worst = max(spots, key=lambda spot: spot.off)
    way, could = _way(spots), speed * (spots[-1].time - max(sent[0].time, first))
    if worst.off > EDGE:
        text = f"{when}the vehicle {say_off(worst.off, worst.time)}."
        return Finding(False, text, _why(run, sent) or _sleeps(run) or hint)
    if could <= 0 or way < _LEAST * could:
        text = f"{when}the vehicle keeps to its line, but drove {way:.1f} m where {could:.1f} m are asked for."
        stops = [command.time for command in commands(run, first, last) if not command.speed]
        if stops and sent[0].speed >= speed:
            return Finding(False, text, f"It was stopped at {say(stops[0])}. {hint}")
        slow = f"Its speed was {sent[0].speed:g} m/s. " if sent[0].speed < speed else ""
        return Finding(False, text, f"{slow}Leave its speed, {speed:g} m/s, as it is: slow vehicles are easy to steer.")
    return Finding(True, f"{when}the vehicle {say_off(worst.off, worst.time)}.")


def stands(run: ObservedRun, first: float, last: float, hint: str) -> Finding:
    """Whether the vehicle stands still from one time (s) to another."""
    spots = [spot for spot in run.drive.spots if first <= spot.time <= last]
    way = _way(spots)
    if way > STILL:
        return Finding(False, f"from {say(first)} to {say(last)} the vehicle drove {way:.1f} m.", hint)
    return Finding(True, f"from {say(first)} to {say(last)} the vehicle stands still.")


def _way(spots: Sequence[Spot]) -> float:
    return sum(math.dist(one[1:3], other[1:3]) for one, other in pairwise(spots))


def _why(run: ObservedRun, sent: Sequence[Command]) -> str:
    """Return a hint for who steers in a wrong way, as opposed to too late; empty if neither is seen."""
    if not any(command.turn for command in sent):
        return f"In each command, the turn is 0: nothing steers. {_unheard(run)}"
    if len({command.turn for command in sent}) == 1 < len(sent):
        return f"The turn is {sent[0].turn:g} in each command. Is it made from the newest offset, each time?"
    vehicle, away = Vehicle(), 0
    for command in sent[:20]:
        spot = min(run.drive.spots, key=lambda spot: abs(spot.time - command.time))
        vehicle.place = Place(spot.x, spot.y, spot.heading)
        away += 1 if vehicle.offset * command.turn < 0 else -1
    if away > 0:
        return "It turns away from the line. Both the offset and the turn are positive to the left."
    return ""


def _unheard(run: ObservedRun) -> str:
    """Say why no command was made from what the sensor saw."""
    if not run.endpoints_of("/line", False):
        others = [each.topic for each in run.endpoints if not each.publishes and each.topic not in _OWN]
        where = f"It subscribes to `{plain(others[0])}`" if others else "It subscribes to nothing"
        return f"{where}, and the vehicle says on `line` how far off it is."
    if run.loops and not any(timer.calls for timer in run.timers):
        return f"A loop, at line {run.loops[0]}, keeps the node from `spin`: no callback is called while it runs."
    if not any(endpoint.joined for endpoint in run.endpoints_of("/line", False)):
        return "Its subscription to `line` is not connected to the vehicle. Both have to name the same type, `Float32`."
    kept = "a member of the object, such as `offset_`" if run.language == "cpp" else "with its `self.`"
    return f"`angular.z` is the turn. Is it made from what the subscription's callback keeps, by the same name, {kept}?"


def _sleeps(run: ObservedRun) -> str:
    """Say which callback of a timer sleeps; empty if none does."""
    if not run.naps:
        return ""
    return f"A timer's callback sleeps, at line {run.naps[0]}: meanwhile no other is called, and its own timer waits."
