"""Reference: whom a noun or a pronoun means."""
