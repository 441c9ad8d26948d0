"""The package of what rclpy needs itself, which defines nothing (source: rclpy/impl/__init__.py)."""

__all__: list[str] = []
__path__: list[str] = []  # what makes it a package
