"""Rules of the reader that the schema does not say, as docs/keys.md lists them, each with what the reader says then."""

RULES = {
    "keys that an axis or a study goes over name numbers of the same file": r"^.*yaml:\d+:\d+: \w+: unknown key, allowed: rotor, stops, kick|cannot hold|is varied beside",
    "numbers that no machine has are slips of units": r"times the lowest natural frequency|of critical damping|contact_radius_m|is no radius"
    r"|is no diameter|softer than|lighter than|are no kick|is no gravity",
    "a number that is not 0 has a magnitude of 1e-30 or more": r"in magnitude|beyond all numbers",
    "a run holds two windows, and max_order fits into half a window": r"two windows|does not resolve max_order|half a window",
    "a kick is shorter than a run": r"are no shorter than a run",
    "the rest position lies inside an annular stop": r"not inside the annular stop",
    "a measured contact force and its penetration rise from 0": r"law\.(force_n|penetration_m)(\.\d+)?: ",
    "friction brakes at every slip": r"which drives the slip|gives a coefficient of",
    "a measured friction curve falls behind its peak": r"below kinetic|from the peak|to the peak|all of the kinetic|no curve with these",
    "an axis has an end unless its count is 1, and different values": r"\.to: missing|cannot be both from and to|different values|is listed twice"
    r"|logarithmic scale",
    "steps lead from one end of an axis to the other": r"no whole number of steps|\.step: .*gives \d+ values",
    "the values of a scan ascend": r"does not ascend|is no scan",
    "a contact by Hertz is longer than wide, and the rotor fits into the hole": r"wider than long|does not fit into the hole|gives a stiffness of",
    "parts stand on the shaft, and only parts of a kit have a place": r"position_m(\.\d+)?: .*(out of range|missing|unknown key)|deflection_m: ",
    "a section has a wall, a disc a body, a bearing room for a shaft": r"no wall is left|no disc is left|no room for a shaft|taper",
    "no body has a polar moment of more than twice its diametral one": r"twice the diametral one",
    "supports hold the shaft and the housings": r"free to move|no housings|on_housing: |at_housing: ",
    "dry friction excludes torsion, damping that turns excludes pedestals": r"beside torsion|pedestals do not",
    "the exact solver knows no blended law, and at most six stops": r"exact solver does not know|is exact beside",
    "a rigid casing has no state": r"of a rigid casing",
    "a sweep has at most 4 000 000 cells, and a refined one axes in order": r" cells, allowed|in no order|points, allowed",
    "an unbalance in g mm needs a disc off the axis": r"has no eccentricity",
    "several keys of an axis have as many factors, not all 0, and no key twice": r"factors: |vary nothing|is there twice|is swept twice|is drawn twice",
    "both ends of an interval differ": r"no other number than from",
    "texts have no hidden characters, and titles one line": r"cannot be shown|is too long",
    "loads of a ring have what their motion knows": r"inclination_deg|does not have it by its motion|rotary_mass_kg|given beside parameter"
    r"|masses and a friction|needs the length of the beam|mass_kg: 0|is not below radius_m|chart\.load: .* out of range|chart\.over",
    "a table of a support has rising speeds and as many coefficients of each kind": r"\.table\b",
    "a matrix has one row per degree of freedom; the mass is symmetric, stiffness and damping are symmetric within each plane, "
    "and the gyroscopic matrix is skew-symmetric": r"rotor\.\w+: (line \d+: |is \d+ x|is zero|is not)"
    r"|rotor\.(mass|stiffness|damping|gyroscopic): (has|couples|acts|turns|is positive)"
    r"|rotor\.(degrees_of_freedom|unbalance)\.\w+: holds|and no r?[xy],|stands twice|is no degree of freedom|no node|two positions"
    r"|neither x nor y|does not turn with|degrees of freedom without position_m",
    "a file of ROSS is there and describes a rotor": r"\.toml|\.json|rotor\.file|rotor\.unbalance",
    "`base` names a file that is there": r"yaml:\d+:\d+: (\S+\.)?base: ",
}
