"""Road networks: junction templates to geometry and topology, no file format."""
