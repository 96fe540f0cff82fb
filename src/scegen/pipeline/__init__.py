"""The stages joined up: a source at any level in, a folder of simulator files out."""
