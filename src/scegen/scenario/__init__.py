"""The three levels of a scenario (PEGASUS): functional, logical, concrete; and their files."""
