"""Who makes the runs: here, in processes, on a cluster."""
