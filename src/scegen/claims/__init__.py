"""Claims: what a description says, as predicates on what moves."""
