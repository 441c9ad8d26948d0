"""What runs give, and what is made of it."""
