"""The player: an ES module without a build step, and the scenes that it plays.

Import from the modules: :mod:`scegen.report.player.scene` makes what is played,
:mod:`scegen.report.player.bundle` gives the module's text for pages of one file.
"""
