"""The rows: topic, what, condition, surface, least, greatest, unit, source. Ranges as their sources print them."""

KENTUCKY = "Kentucky Transportation Center, report 178"
BARTLETT = "Bartlett, update of the friction tables"
TRL = "TRL PPR496"
NOON = "Noon 1994, as tabulated by others"
LAMBOURN = "Lambourn 1979"
GREEN = "Green 2000"
REPLY = "reply to Green, Transportation Human Factors 2(3) 217-226"
WALKING = "TCRP/NCHRP 2005; Gates et al. 2006"
WHITE = "White 2021"
DAY = "Day & Smith 1984, Raftery 1995, both as reported by others"
ECKER = "Ecker et al. 2001"
EUBANKS = "as listed by Eubanks"
SAE_LOW = "SAE 931842"
ROSE = "Rose & Beauchamp, and tests quoted there"
AMIRAULT = "Amirault & MacInnis 2009, 29 tests, 1 σ"
BRAKED_YAW = "SAE 2003-01-0888"
REUST = "Reust & Morgan 2007, abstract; one make's module"
RULE = "49 CFR 563.8, table III: what a maker must meet"
BATISTA = "Batista 2008"

# surface "": none; least None: no lower end is printed
ROWS: "tuple[tuple[str, str, str, str, float | None, float, str, str], ...]" = (
    ("friction", "tyres, clean pavement", "dry", "pavement", 0.6, 0.8, "", KENTUCKY),
    ("friction", "tyres, means of tests since the 1980s", "dry; the common table of 1975 is too low", "asphalt",
     0.72, 0.78, "", BARTLETT),
    ("friction", "locked tyres, 32 to 100 km/h", "dry; four tyres alike within 0.2", "asphalt", 0.7, 0.9, "", TRL),
    ("friction", "tyres, peak, about", "dry", "asphalt", 1.2, 1.2, "", TRL),
    ("friction", "tyres", "dry", "asphalt", 0.65, 0.65, "", NOON),
    ("friction", "tyres", "wet", "asphalt", 0.50, 0.50, "", NOON),
    ("friction", "tyres", "dry", "concrete", 0.75, 0.75, "", NOON),
    ("friction", "tyres", "wet", "concrete", 0.60, 0.60, "", NOON),
    ("friction", "tyres", "", "gravel", 0.35, 0.35, "", NOON),
    ("friction", "tyres", "", "snow", 0.20, 0.25, "", NOON),
    ("friction", "tyres", "", "ice", 0.10, 0.15, "", NOON),
    ("friction", "tyres", "wet", "grass", 0.20, 0.20, "", NOON),
    ("slide", "motorcycle on its side", "standard", "", 0.45, 0.58, "", DAY),
    ("slide", "motorcycle on its side", "with fairing", "", 0.26, 0.26, "", DAY),
    ("slide", "motorcycle on its side", "the same without fairing", "", 0.33, 0.33, "", DAY),
    ("slide", "pedestrian sliding", "Aronberg & Snider", "", 0.50, 0.50, "", EUBANKS),
    ("slide", "pedestrian sliding", "Hague", "", 0.62, 0.62, "", EUBANKS),
    ("slide", "pedestrian sliding", "Searle; later", "", 0.66, 0.70, "", EUBANKS),
    ("slide", "pedestrian sliding", "Collins", "", 0.80, 0.80, "", EUBANKS),
    ("roll", "roll drag, three rollovers of 35 to 44 m", "soil-tripped", "soil", 0.52, 0.53, "", ROSE),
    ("roll", "roll drag along one filmed crash", "highest early", "", 0.2, 0.6, "", ROSE),
    ("reaction", "brake reaction, expected", "", "", 0.70, 0.75, "s", GREEN),
    ("reaction", "brake reaction, common signal", "", "", 1.25, 1.25, "s", GREEN),
    ("reaction", "brake reaction, surprise", "", "", 1.5, 1.5, "s", GREEN),
    ("reaction", "brake reaction, urgent", "4 s to the collision", "", 1.0, 1.3, "s", REPLY),
    ("reaction", "brake reaction, norms of road design", "Europe; US", "", 2.0, 2.5, "s", "as quoted beside " + GREEN),
    ("walking", "walking, 15th percentile", "up to 60 years", "", 1.15, 1.15, "m/s", WALKING),
    ("walking", "walking, 15th percentile", "above 60 years", "", 0.92, 0.92, "m/s", WALKING),
    ("walking", "walking, 15th percentile; mean", "65 years and above", "", 0.92, 1.16, "m/s", WALKING),
    ("lane change", "lane change on motorways", "15 to 85 %; median 5 s", "", 4.0, 6.0, "s", WHITE),
    ("braking", "riders' share of the possible braking", "half of the riders", "", None, 56.0, "%", ECKER),
    ("restitution", "vehicles, ΔV 2 to 5 mph", "", "", 0.2, 0.4, "", SAE_LOW),
    ("restitution", "vehicles, medium and high speed, about", "", "", 0.1, 0.1, "", SAE_LOW),
    ("method", "speed from skid marks", "all wheels locked, dry, friction measured there", "", -5.0, 5.0,
     "%", LAMBOURN),
    ("method", "critical speed of yaw, 20 m chord, over true", "+4.1 ± 6.3", "", -2.2, 10.4, "%", AMIRAULT),
    ("method", "critical speed of yaw, mass centre, over true", "-2.0 ± 5.2", "", -7.2, 3.2, "%", AMIRAULT),
    ("method", "critical speed of yaw, error by braking", "generally below", "", None, 14.0, "%", BRAKED_YAW),
    ("method", "pedestrian regressions by throw distance, about", "", "", -10.0, 10.0, "km/h", BATISTA),
    ("record", "recorded speed", "rule", "", -1.0, 1.0, "km/h", RULE),
    ("record", "recorded ΔV", "rule", "", -10.0, 10.0, "%", RULE),
    ("record", "recorded minus true speed", "low and normal acceleration", "", -1.5, 1.5, "mph", REUST),
    ("record", "recorded minus true speed", "coasting", "", -2.0, 0.5, "mph", REUST),
    ("record", "recorded minus true speed", "yaw, steering only, from 30 mph", "", -7.0, -2.0, "%", REUST),
    ("record", "recorded minus true speed", "yaw with braking, from 30 mph", "", -18.0, -3.0, "%", REUST),
    ("record", "recorded minus true speed", "hardest braking, ABS working", "", -18.0, -8.0, "%", REUST),
)  # fmt: skip
