"""The executor of rclpy.experimental, which is refused by its name (source: rclpy/experimental/__init__.py)."""

__all__: list[str] = []
