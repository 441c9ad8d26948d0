"""The exercises on ROS 2."""

from . import questions
from .exercise import Exercises

EXERCISES = Exercises(ros=2, first=len(questions.EXERCISES) + 1)
