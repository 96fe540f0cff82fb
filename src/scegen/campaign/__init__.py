"""Many descriptions, many scenarios: planned, made on many processors, kept, looked through."""
