"""One rule per file: each looks at a network and yields findings."""
