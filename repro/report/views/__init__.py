"""What the pages show, arranged for the templates."""
