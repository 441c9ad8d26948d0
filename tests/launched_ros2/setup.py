from glob import glob

from setuptools import setup

package_name = "launched"

setup(
    name=package_name,
    version="0.0.0",
    packages=[package_name],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),
        ("share/" + package_name, ["package.xml"]),
        (f"share/{package_name}/launch", glob("launch/*")),
        (f"share/{package_name}/config", glob("config/*")),
    ],
    entry_points={
        "console_scripts": [
            "show = launched.show:main",
            "ends = launched.ends:main",
            "waits = " + package_name + ".waits:main",
            f"prints = {package_name}.prints:main",
        ],
    },
)
