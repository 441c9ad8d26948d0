"""What a logger does not take, and what it makes of values that are no text."""

import rclpy
from rclpy.logging import LoggingSeverity, get_logger, get_logging_severity_from_string
from scenario import attempt, say

rclpy.init()
node = rclpy.create_node("log_errors")
logger = node.get_logger()
names = {
    **{"logger": logger, "LoggingSeverity": LoggingSeverity, "get_logger": get_logger, "node": node},
    **{"severity": get_logging_severity_from_string},
}
for text in """
logger.info('returned')
logger.debug('not printed')
logger.info('two\\nlines')
logger.info('')
logger.info('%s %d {}')
logger.info('ä € ☃')
logger.info()
logger.info('a', 'b')
logger.info('a', unknown=True)
logger.info('a', throttle_duration_sec=None)
logger.log('by severity', LoggingSeverity.WARN)
logger.log('by number', 30)
logger.log('by name', 'WARN')
logger.get_effective_level()
logger.is_enabled_for(LoggingSeverity.DEBUG)
logger.set_level('DEBUG')
logger.set_level(LoggingSeverity.WARN)
logger.is_enabled_for(LoggingSeverity.INFO)
logger.set_level(5)
logger.get_child('')
logger.get_child('child').name
logger.name
get_logger('').name
get_logger(None)
severity('warn')
severity('nonsuch')
LoggingSeverity(30)
""".strip().splitlines():
    attempt(text, names)


def changing(severity):
    logger.log("changing", severity)


changing(LoggingSeverity.ERROR)
try:
    changing(LoggingSeverity.FATAL)
except ValueError as error:
    say(error)


def filters(**options):
    logger.error("filtered", **options)


filters(once=True)
try:
    filters(skip_first=True)
except ValueError as error:
    say(error)
