"""Tools of the fork."""
