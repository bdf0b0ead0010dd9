"""One module per source paper and nothing else: each declares PAPER."""
