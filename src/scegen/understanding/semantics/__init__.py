"""What clauses mean: rows of data, and what matches and applies them."""
