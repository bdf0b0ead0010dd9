"""Second implementations of optimisers and functions in plain Python, one draw at a time."""
