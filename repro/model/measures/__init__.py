"""What can be measured for a claim."""
