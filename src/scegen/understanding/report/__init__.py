"""Reports on a reading: for readers, against labels, and where two readings disagree."""
