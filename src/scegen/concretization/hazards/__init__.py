"""One small rule per danger: what makes it happen in numbers."""
