"""A private parameter on the command line that is no YAML."""

from scenario import attempt

attempt("rospy.init_node('values_bad_parameter')")
