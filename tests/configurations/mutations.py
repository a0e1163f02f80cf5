"""Configurations with one thing changed, for a comparison of schema and reader."""

import copy
import math

WRONG_TYPES = ["text", "", None, True, [], [1.5], {}, {"a": 1}, -1, 0, 3.5, 7]
NUMBERS = [-1e31, -1e3, -1.0, -1e-9, 0, 1e-9, 0.2, 0.2636, 0.5, 0.99, 1, 1.5, 2, 3, 10.5, 11, 16, 41, 101, 1e3, 1e7, 2e9, 1e31]


def paths(value, path=()):
    """Places of everything in a configuration, itself not included."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield path + (key,)
        yield from paths(inner, path + (key,))


def at(value, path):
    for key in path:
        value = value[key]
    return value


class Mutator:
    """Makes mutations of `seeds` with the words and keys that `schema` knows, by the numbers of `random`."""

    def __init__(self, seeds, schema, random):
        self.seeds, self.random = seeds, random
        self.definitions = schema["definitions"]
        self.words = sorted({word for one in _all(schema) for word in one.get("enum", ())})
        self.properties = sorted({(name, _text(value)) for one in _all(schema) for name, value in one.get("properties", {}).items()
                                  if isinstance(value, dict) and "allOf" in value})
        self.by_text = {_text(value): value for one in _all(schema) for value in one.get("properties", {}).values()
                        if isinstance(value, dict)}

    def mutated(self):
        """A copy of a seed with one mutation, and the kind of it."""
        root = copy.deepcopy(self.random.choice(self.seeds))
        kind = self.random.choice(["type", "number", "word", "unknown", "missing", "added", "moved"])
        getattr(self, "_" + kind)(root)
        return kind, root

    def _place(self, root, fits=lambda value: True):
        places = [path for path in paths(root) if fits(at(root, path))]
        if not places:
            return root, next(iter(root))
        path = self.random.choice(places)
        return at(root, path[:-1]), path[-1]

    def _map(self, root):
        maps = [root] + [at(root, path) for path in paths(root) if isinstance(at(root, path), dict)]
        return self.random.choice(maps)

    def _type(self, root):
        where, key = self._place(root)
        where[key] = copy.deepcopy(self.random.choice(WRONG_TYPES))

    def _number(self, root):
        where, key = self._place(root, lambda value: isinstance(value, (int, float)) and not isinstance(value, bool))
        where[key] = self.random.choice(NUMBERS)

    def _word(self, root):
        where, key = self._place(root, lambda value: isinstance(value, str))
        where[key] = self.random.choice(self.words)

    def _unknown(self, root):
        where = self._map(root)
        known = self.random.choice(sorted(where) or ["kind"])
        where[known + self.random.choice(["x", "_m", "s"])] = 1.5

    def _missing(self, root):
        where, key = self._place(root)
        del where[key]

    def _added(self, root):
        name, text = self.random.choice(self.properties)
        self._map(root)[name] = self.sample(self.by_text[text])

    def _moved(self, root):
        """A value goes to a key that the same map knows, or that some other map does."""
        where, key = self._place(root)
        if isinstance(where, dict):
            where[self.random.choice(self.properties)[0]] = where.pop(key)

    def sample(self, schema):
        """A value that a schema of a property allows, taken by itself."""
        if "allOf" in schema and "properties" not in schema:
            return self.sample(schema["allOf"][0])
        if "$ref" in schema:
            return self.sample(self.definitions[schema["$ref"].split("/")[-1]])
        if "anyOf" in schema and "properties" not in schema:
            return self.sample(self.random.choice(schema["anyOf"]))
        if "enum" in schema:
            return self.random.choice(schema["enum"])
        if "else" in schema:
            return self.sample(schema["else"])
        kind = schema["type"]
        if kind in ("number", "integer"):
            return self._sampled_number(schema, kind)
        if kind == "array":
            return [self.sample(schema["items"]) for _ in range(max(schema["minItems"], self.random.randint(1, 2)))]
        if kind == "object":
            return {name: self.sample(schema["properties"][name]) for name in schema.get("required", ())}
        return None if kind == "null" else "text"

    def _sampled_number(self, schema, kind):
        low = schema.get("minimum", schema.get("exclusiveMinimum"))
        high = schema.get("maximum", schema.get("exclusiveMaximum"))
        if kind == "integer":
            step = schema.get("multipleOf", 1)
            return self.random.choice([low, min(high, low + 2 * step)]) // step * step
        inside = [low, high] if "minimum" in schema and "maximum" in schema else []
        middle = 0.5 * (low + high) if high - low < 1e3 else max(low, -1) + 1.25
        return self.random.choice(inside + [middle if math.isfinite(middle) else 1.5])


def _all(schema):
    """Every map in a schema."""
    if isinstance(schema, dict):
        yield schema
        for value in schema.values():
            yield from _all(value)
    elif isinstance(schema, list):
        for value in schema:
            yield from _all(value)


def _text(value):
    return repr(value)
