"""What people look at: the gallery of logical scenarios, previews, the HTML report.

Import from the modules: :mod:`scegen.report.gallery`, :mod:`scegen.report.preview` and
:mod:`scegen.report.html`. Nothing is imported here, so that nobody pays for pictures not drawn.
"""
