"""Building: from the draft to the functional scenario, with evidence and what is left over."""
