"""python -m scegen: the command line."""

from scegen.cli import main

main()
