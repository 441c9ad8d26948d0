from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnShutdown


def generate_launch_description():
    return LaunchDescription(
        [RegisterEventHandler(OnShutdown(on_shutdown=lambda event, context: LogInfo(msg=f"why: {event.reason}")))]
    )
