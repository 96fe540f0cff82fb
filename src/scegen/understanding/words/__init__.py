"""Words: tokens, spelling, numbers, and the terms of the lexicon with the meaning that fits."""
