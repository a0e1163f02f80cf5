"""Phases that go on where they pass a whole turn."""


def beside(phase_deg, other_deg):
    """The phase in degrees, moved by whole turns to where it is nearest to another one; as it is where that is None."""
    return phase_deg if other_deg is None else phase_deg - 360 * round((phase_deg - other_deg) / 360)
