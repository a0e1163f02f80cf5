"""One module for each subcommand that draws: what its tables hold, laid out for its template."""
