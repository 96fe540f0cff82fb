"""One file per kind of statement: what it means for what moves."""
