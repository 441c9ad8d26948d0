"""What rosspin costs, and the recordings of the real ROS: see __main__.py and record.py."""
