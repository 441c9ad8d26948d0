"""Every value and error of Time."""

import rospy
from scenario import attempt

for text in """
rospy.Time()
rospy.Time(1)
rospy.Time(1, 5)
rospy.Time(1, 1500000000)
rospy.Time(2, -1)
rospy.Time(1.25)
rospy.Time(1.1)
rospy.Time(0.1 + 0.2)
rospy.Time(1, 2.7)
rospy.Time(1.5, 2)
rospy.Time(-1)
rospy.Time(-0.25)
rospy.Time(0, -1)
rospy.Time(nsecs=7)
rospy.Time(secs=3)
rospy.Time('1')
rospy.Time(None)
rospy.Time([1])
rospy.Time(True)
rospy.Time(float('nan'))
rospy.Time(float('inf'))
rospy.Time(2**40)
rospy.Time.from_sec(2.5)
rospy.Time.from_sec(-2.5)
rospy.Time.from_sec(1.1)
rospy.Time.from_sec('1')
rospy.Time.from_seconds(2.5)
str(rospy.Time(1, 5))
'%s' % rospy.Time(12, 30000)
hash(rospy.Time(1, 5)) == hash(rospy.Time(1, 5))
rospy.Time(1.5).to_sec()
rospy.Time(1.5).to_nsec()
rospy.Time(1.5).to_time()
rospy.Time(1.5).secs
rospy.Time(1.5).nsecs
rospy.Time(0).is_zero()
rospy.Time(0, 1).is_zero()
bool(rospy.Time(0))
bool(rospy.Time(0, 1))
rospy.Time(1) + rospy.Duration(0.5)
rospy.Duration(0.5) + rospy.Time(1)
rospy.Time(1) - rospy.Duration(0.5)
rospy.Time(1) - rospy.Duration(1.5)
rospy.Time(1) - rospy.Time(0.25)
rospy.Time(1) - rospy.Time(3.25)
isinstance(rospy.Time(1) - rospy.Time(0.25), rospy.Duration)
isinstance(rospy.Time(1) + rospy.Duration(1), rospy.Time)
rospy.Time(1) + rospy.Time(1)
rospy.Time(1) + 1
rospy.Time(1) - 1
1 + rospy.Time(1)
1 - rospy.Time(1)
rospy.Duration(1) - rospy.Time(1)
rospy.Time(1) * 2
rospy.Time(1) / 2
-rospy.Time(1)
abs(rospy.Time(1))
rospy.Time(1) == rospy.Time(1, 0)
rospy.Time(1) != rospy.Time(1, 1)
rospy.Time(1) == 1
rospy.Time(1) == rospy.Duration(1)
rospy.Time(1) < rospy.Time(2)
rospy.Time(1) >= rospy.Time(1)
rospy.Time(1) < 2
rospy.Time(1) > rospy.Duration(1)
max(rospy.Time(1), rospy.Time(2))
sorted([rospy.Time(2), rospy.Time(1)])
{rospy.Time(1): 'a'}[rospy.Time(1)]
float(rospy.Time(1))
int(rospy.Time(1))
rospy.Time(1).anything
rospy.Time.now()
rospy.get_time()
rospy.get_rostime()
rospy.rostime.is_wallclock()
rospy.rostime.get_rostime()
""".strip().splitlines():
    attempt(text)

time = rospy.Time(1, 5)
time.secs, time.nsecs = 1, 2500000000
time.canon()
print(repr(time))
time.set(3, 4)
print(repr(time))
