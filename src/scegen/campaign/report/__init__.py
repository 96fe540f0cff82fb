"""The report of a campaign: one HTML page that opens offline, and a page of the player for some."""
