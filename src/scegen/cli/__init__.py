"""The command line. Commands load what they need when they run, so that --help is instant."""

from scegen.cli.app import main

__all__ = ["main"]
