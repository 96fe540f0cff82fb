"""What the rows of a campaign say together: coverage, likeness, what is critical, a suite."""
