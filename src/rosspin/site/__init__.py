"""What Sphinx and Jupyter need to show runs. The page's own Python does without."""
