from launch.actions import Lost
