"""Every value and error of Duration."""

from scenario import attempt

for text in """
rospy.Duration()
rospy.Duration(1)
rospy.Duration(1, 5)
rospy.Duration(0, 1500000000)
rospy.Duration(2, -1)
rospy.Duration(-0.25)
rospy.Duration(-0.25).secs
rospy.Duration(-0.25).nsecs
rospy.Duration(-1, 5)
rospy.Duration(0, -5)
rospy.Duration(0.1)
rospy.Duration(1.1)
rospy.Duration(1/3)
rospy.Duration(1.5, 2)
rospy.Duration(1.5, 0)
rospy.Duration('1')
rospy.Duration(None)
rospy.Duration(float('nan'))
rospy.Duration(float('inf'))
rospy.Duration(True)
rospy.Duration.from_sec(0.5)
rospy.Duration.from_sec(-0.3)
str(rospy.Duration(0.5))
str(rospy.Duration(-0.5))
'%s' % rospy.Duration(1, 2)
rospy.Duration(0.5).to_sec()
rospy.Duration(-0.25).to_sec()
rospy.Duration(-0.25).to_nsec()
rospy.Duration(0).is_zero()
bool(rospy.Duration(0))
bool(rospy.Duration(-1))
-rospy.Duration(0.25)
-rospy.Duration(0)
abs(rospy.Duration(-0.25))
abs(rospy.Duration(0.25))
rospy.Duration(1) + rospy.Duration(0.5)
rospy.Duration(1) - rospy.Duration(1.5)
rospy.Duration(1) + 1
rospy.Duration(1) - 1
1 + rospy.Duration(1)
1 - rospy.Duration(1)
rospy.Duration(1.5) * 2
2 * rospy.Duration(1.5)
rospy.Duration(1.5) * 0.5
rospy.Duration(-1.5) * 0.5
rospy.Duration(1.5) * '2'
rospy.Duration(1) * rospy.Duration(1)
rospy.Duration(1.5) / 2
rospy.Duration(1.5) / 0.5
rospy.Duration(1.5) / rospy.Duration(0.5)
rospy.Duration(1.5) / 0
rospy.Duration(1.5) / rospy.Duration(0)
2 / rospy.Duration(1)
rospy.Duration(1.5) // 1
rospy.Duration(1.7) // 0.5
rospy.Duration(1.7) // rospy.Duration(0.5)
rospy.Duration(1.7) % rospy.Duration(0.5)
rospy.Duration(-1.7) % rospy.Duration(0.5)
rospy.Duration(1.7) % 1
divmod(rospy.Duration(1.75), rospy.Duration(0.5))
divmod(rospy.Duration(1.75), 1)
isinstance(-rospy.Duration(1), rospy.Duration)
isinstance(rospy.Duration(1) + rospy.Duration(1), rospy.Duration)
isinstance(rospy.Duration(1) * 2, rospy.Duration)
isinstance(rospy.Duration(1) / 2, rospy.Duration)
isinstance(rospy.Duration(1) % rospy.Duration(2), rospy.Duration)
rospy.Duration(1) == rospy.Duration(0, 1000000000)
rospy.Duration(1) == 1
rospy.Duration(1) != rospy.Time(1)
rospy.Duration(1) < rospy.Duration(1.5)
rospy.Duration(-1) < rospy.Duration(0)
rospy.Duration(1) < 2
rospy.Duration(1) <= rospy.Time(1)
sum([rospy.Duration(1), rospy.Duration(2)], rospy.Duration(0))
sum([rospy.Duration(1), rospy.Duration(2)])
hash(rospy.Duration(1)) == hash(rospy.Duration(0, 1000000000))
float(rospy.Duration(1))
rospy.Duration(1).to_time()
""".strip().splitlines():
    attempt(text)
