"""A client and a server of an action in one process."""

import sys

import actionlib
import rospy
from actionlib.msg import TestAction, TestFeedback, TestGoal, TestResult, TwoIntsAction
from actionlib_msgs.msg import GoalStatus

rospy.init_node("node")


def say(*words):
    sys.stdout.write(" ".join(map(str, words)) + "\n")
    sys.stdout.flush()


def attempt(text):
    try:
        value = eval(text)
    except Exception as error:
        value = type(error).__name__, error
    say(text, "->", value)


def execute(goal):
    say("goal", goal.goal)
    for number in range(goal.goal):
        rospy.sleep(0.1)
        if server.is_preempt_requested():
            say("preempted", number)
            server.set_preempted(TestResult(number), "enough")
            return
        if number == 1:
            server.publish_feedback(TestFeedback(number))
    if goal.goal == 3:
        server.set_aborted(text="no three")
    elif goal.goal == 4:
        raise ValueError("no four")
    elif goal.goal != 5:
        server.set_succeeded(TestResult(goal.goal), "done")


def done(status, result):
    told.append(("done", GoalStatus.to_string(status), result.result))


told = []  # callbacks, of which each comes in a thread of its own


def show():
    rospy.sleep(0.2)  # else the server may not wait yet for the next goal
    say(*told)
    told.clear()
    say(client.get_state(), client.get_result(), repr(client.get_goal_status_text()))


attempt("actionlib.SimpleActionClient('fly', GoalStatus)")
client = actionlib.SimpleActionClient("fly", TestAction)
attempt("client.get_state(), client.get_result(), client.get_goal_status_text(), client.wait_for_result()")
attempt("client.wait_for_server(rospy.Duration(0.3))")
server = actionlib.SimpleActionServer("fly", TestAction, execute, auto_start=False)
server.start()
attempt("client.wait_for_server()")
attempt("client.wait_for_server(rospy.Duration(5))")

client.send_goal(TestGoal(2), done, None, lambda feedback: say("feedback", feedback.feedback))
attempt("client.wait_for_result()")
show()
for goal in (3, 4, 5):
    attempt(f"client.send_goal_and_wait(TestGoal({goal}), rospy.Duration(3), rospy.Duration(1))")
    show()
attempt("client.send_goal_and_wait(TestGoal(20), rospy.Duration(0.55), rospy.Duration(1))")
show()
client.send_goal(TestGoal(20), done)
rospy.sleep(0.55)
attempt("client.get_state(), client.wait_for_result(rospy.Duration(0.3))")
client.send_goal(TestGoal(1), done)
attempt("client.wait_for_result(rospy.Duration(3))")
show()
client.send_goal(TestGoal(20), done)
rospy.sleep(0.55)
client.cancel_all_goals()
attempt("client.wait_for_result(rospy.Duration(3))")
show()
client.send_goal(TestGoal(20))
rospy.sleep(0.55)
client.cancel_goals_at_and_before_time(rospy.Time.now())
attempt("client.wait_for_result(rospy.Duration(3))")
client.stop_tracking_goal()
attempt("client.get_state()")


def take(handle):
    say("taken", handle.get_goal(), handle.get_goal_status().status, handle.get_default_result().sum)
    handle.set_succeeded()
    handle.set_accepted("yes")
    handle.set_rejected()
    handles.append(handle)


def follow(handle):
    told.append((actionlib.CommState.to_string(handle.get_comm_state()), handle.get_goal_status()))


handles = []
many = actionlib.ActionServer("many", TwoIntsAction, take, lambda handle: say("cancel", handle == handles[0]), False)
many.start()
asks = actionlib.ActionClient("many", TwoIntsAction)
attempt("asks.wait_for_server()")
rospy.sleep(0.5)
sent = [asks.send_goal(asks.ActionGoal().goal, follow, lambda handle, feedback: say("feedback", feedback))]
rospy.sleep(0.5)
handles[0].publish_feedback(asks.ActionFeedback().feedback)
rospy.sleep(0.5)
attempt("told")
attempt("sent[0].get_terminal_state(), sent[0].get_result()")
sent[0].cancel()
rospy.sleep(0.5)
handles[0].set_canceled(None, "as you wish")
rospy.sleep(0.5)
attempt("actionlib.TerminalState.to_string(sent[0].get_terminal_state()), sent[0].get_goal_status_text()")
attempt("sent[0].get_result(), sent[0] == sent[0], sent[0] != None")
attempt("told")
told.clear()
attempt("[GoalStatus.to_string(number) for number in range(1, 11)]")
attempt("[actionlib.SimpleGoalState.to_string(number) for number in range(4)]")
asks.stop()
many.stop()

waits = actionlib.SimpleActionServer("waits", TestAction, auto_start=False)
waits.register_goal_callback(lambda: say("a goal", waits.is_new_goal_available(), waits.is_active()))
waits.register_preempt_callback(lambda: say("preempt", waits.is_preempt_requested()))
server.register_goal_callback(None)
waits.start()
attempt("waits.accept_new_goal()")
first, second = (actionlib.SimpleActionClient("waits", TestAction) for _ in range(2))
attempt("first.wait_for_server(), second.wait_for_server()")
first.send_goal(TestGoal(7), done)
rospy.sleep(0.3)
attempt("waits.accept_new_goal(), waits.is_active()")
second.send_goal(TestGoal(8), done)
rospy.sleep(0.3)
attempt("waits.accept_new_goal(), waits.is_active()")
rospy.sleep(0.3)
attempt("first.get_state(), second.get_state(), told")
waits.set_succeeded()
rospy.sleep(0.3)
attempt("second.get_state(), told")
rospy.signal_shutdown("end")
