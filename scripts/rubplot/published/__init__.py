"""The published figures: configurations, cells and headings, computed by the programs and then drawn."""
