from launch.actions import Lost


def generate_launch_description():
    return Lost()
