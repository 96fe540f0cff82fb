"""One rule per file: each looks at a situation and yields findings."""
