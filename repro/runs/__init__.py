"""From tasks to stored runs to evidence."""
