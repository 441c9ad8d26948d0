"""Lines that come once, not the first time, or not too often."""

import rclpy
from scenario import P, begin, end_after, mark


def callback():
    global calls
    calls += 1
    logger.info(f"once {calls}", once=True)
    logger.info(f"not first {calls}", skip_first=True)
    logger.info(f"throttled {calls}", throttle_duration_sec=2.5 * P)
    logger.warn(f"throttled, not first {calls}", throttle_duration_sec=2.5 * P, skip_first=True)
    if calls == 9:
        timer.cancel()
        mark("last")


calls = 0
rclpy.init()
node = rclpy.create_node("log_control")
logger = node.get_logger()
begin()
timer = node.create_timer(P, callback)
end_after(9.5)
rclpy.spin(node)
