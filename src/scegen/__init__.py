"""ML-SceGen: from an English sentence to simulator-ready traffic scenarios."""

__version__ = "0.1.0"
