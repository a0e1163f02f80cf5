"""A part of a list that stands for all of it."""


def spread(items, count):
    """At most `count` of the items, evenly spread over their list."""
    if len(items) <= count:
        return list(items)
    return [items[int((i + 0.5) * len(items) / count)] for i in range(count)]
