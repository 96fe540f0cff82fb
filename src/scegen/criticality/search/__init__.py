"""Search: every danger asked for at once, and the measure of a pair in its band."""
