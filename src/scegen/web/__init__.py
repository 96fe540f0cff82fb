"""The page: from a sentence to files in a browser, over the same functions as the command line."""
