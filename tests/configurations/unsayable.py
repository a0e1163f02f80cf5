"""Rules of the reader that the schema does not say, as docs/keys.md lists them, each with what the reader says then."""

RULES = {
    "the keys of an axis or a study name numbers of the same file": r"^.*yaml:\d+:\d+: \w+: unknown key, allowed: rotor, stops, kick|cannot hold|is varied beside",
    "numbers that no machine has are refused as": r"times the lowest natural frequency|of critical damping|contact_radius_m|is no radius"
    r"|is no diameter|softer than|lighter than|are no kick|is no gravity",
    "a number is 0 or has a magnitude of at least 1e-30": r"in magnitude|beyond all numbers",
    "a run is at least two windows long, `max_order` at most half a window": r"two windows|does not resolve max_order|half a window",
    "a kick shorter than a run": r"are no shorter than a run",
    "the rest position lies inside an annular stop": r"not inside the annular stop",
    "a measured contact force and its penetration rise from 0": r"law\.(force_n|penetration_m)(\.\d+)?: ",
    "friction opposes the slip at every slip speed": r"which drives the slip|gives a coefficient of",
    "a measured friction curve falls beyond its peak": r"below kinetic|from the peak|to the peak|all of the kinetic|no curve with these",
    "an axis has an upper end unless its count is 1, and no value twice": r"\.to: missing|cannot be both from and to|different values|is listed twice"
    r"|logarithmic scale",
    "steps lead from one end of an axis to the other": r"no whole number of steps|\.step: .*gives \d+ values",
    "the values of a scan ascend": r"does not ascend|is no scan",
    "a Hertz contact is longer than wide, and the rotor fits into the hole": r"wider than long|does not fit into the hole|gives a stiffness of",
    "parts lie within the length of the shaft, and only parts of a kit have a position": r"position_m(\.\d+)?: .*(out of range|missing|unknown key)|deflection_m: ",
    "a bearing's dimensions leave room for the shaft": r"no wall is left|no disc is left|no room for a shaft|taper",
    "no polar moment of inertia is more than twice the diametral moment": r"twice the diametral one",
    "supports hold the shaft and the housings": r"free to move|no housings|on_housing: |at_housing: ",
    "dry friction excludes torsion, rotating damping excludes pedestals": r"beside torsion|pedestals do not",
    "the exact solver takes at most six stops and no smoothed contact": r"exact solver does not know|is exact beside",
    "a rigid casing has no state": r"of a rigid casing",
    "a sweep has at most 4 000 000 cells; the axes of a refined map rise or fall": r" cells, allowed|in no order|points, allowed",
    "an unbalance in g mm needs a disc off the axis": r"has no eccentricity",
    "an axis over several keys has a factor for each key, not all factors are 0, and no key occurs twice": r"factors: |vary nothing|is there twice|is swept twice|is drawn twice",
    "both ends of an interval differ": r"no other number than from",
    "texts have no control characters, and titles one line": r"cannot be shown|is too long",
    "loads of a ring have the keys that belong to their `motion`": r"inclination_deg|does not have it by its motion|rotary_mass_kg|given beside parameter"
    r"|masses and a friction|needs the length of the beam|mass_kg: 0|is not below radius_m|chart\.load: .* out of range|chart\.over",
    "a table of a support has rising speeds and one coefficient of each kind per speed": r"\.table\b",
    "a matrix has one row per degree of freedom; the mass is symmetric, stiffness and damping are symmetric within each plane, "
    "and the gyroscopic matrix is skew-symmetric": r"rotor\.\w+: (line \d+: |is \d+ x|is zero|is not)"
    r"|rotor\.(mass|stiffness|damping|gyroscopic): (has|couples|acts|turns|is positive)"
    r"|rotor\.(degrees_of_freedom|unbalance)\.\w+: holds|and no r?[xy],|stands twice|is no degree of freedom|no node|two positions"
    r"|neither x nor y|does not turn with|degrees of freedom without position_m",
    "a file of ROSS exists and describes a rotor": r"\.toml|\.json|rotor\.file|rotor\.unbalance",
    "`base` names an existing file": r"yaml:\d+:\d+: (\S+\.)?base: ",
}
