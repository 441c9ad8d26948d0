"""ROSCONSOLE_FORMAT's times: how many digits, whatever they are."""

import os

os.environ["ROSCONSOLE_FORMAT"] = "[${time}] [${walltime}] [${time:%Y}] [${walltime:%H}] ${message}"

import io  # noqa: E402
import re  # noqa: E402
import sys  # noqa: E402

import rospy  # noqa: E402

stdout, sys.stdout = sys.stdout, io.StringIO()
rospy.init_node("log_time_format")
rospy.loginfo("text")
text, sys.stdout = sys.stdout.getvalue(), stdout
print(re.sub(r"\d+", lambda number: "N" * (len(number[0]) if len(number[0]) == 6 else 1), text), end="")
