from setuptools import setup

package_name = 'my_robotics_pkg'

setup(
    name=package_name,
    version='0.1.0',
    packages=[package_name],
    data_files=[
        ('share/ament_index/resource_index/packages',
            ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='The rosspin maintainers',
    maintainer_email='maintainer@example.org',
    description='The nodes of the ROS 2 tutorial',
    license='MIT',
    # A name for ros2 run, and the function that it calls
    entry_points={
        'console_scripts': [
            'plain_py_node = my_robotics_pkg.plain_py_node:main',
            'spinner_py_node = my_robotics_pkg.spinner_py_node:main',
            'spinner_rate_py_node = '
            'my_robotics_pkg.spinner_rate_py_node:main',
            'spinner_param_py_node = '
            'my_robotics_pkg.spinner_param_py_node:main',
            'publisher_py_node = my_robotics_pkg.publisher_py_node:main',
            'subscriber_py_node = my_robotics_pkg.subscriber_py_node:main',
            'both_py_nodes = my_robotics_pkg.both_py_nodes:main',
            'stamped_py_node = my_robotics_pkg.stamped_py_node:main',
        ],
    },
)
