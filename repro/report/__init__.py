"""Pages, figures and result files, made from findings."""
