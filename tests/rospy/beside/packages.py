"""What rospkg and roslib say of a package that is not there."""

import rospkg
from roslib import packages
from rospkg.common import ResourceNotFound

rospack = rospkg.RosPack()
print(rospkg.RosPack.get_instance() is rospkg.RosPack.get_instance(), rospkg.RosPack.get_instance() is rospack)
for find in (rospack.get_path, packages.get_pkg_dir):
    for name in ("nowhere", "", "no/where"):
        try:
            find(name)
        except (ResourceNotFound, packages.ROSPkgException) as error:
            print(type(error).__module__, type(error).__name__, type(error).__base__.__name__, len(error.args))
            print(repr(str(error).splitlines()[0].partition(":")[0]))
print(packages.get_pkg_dir("nowhere", required=False))
print(rospkg.ResourceNotFound("nowhere", ["/one", "/two"]))
print(rospkg.ResourceNotFound("nowhere").ros_paths, ResourceNotFound is rospkg.ResourceNotFound)
