// programs.mjs — what the tests run.

/** Lines, an arc, a turn about the tip, along great circles and through the pole. */
export const kFiveAxes = `N10 G17 G54 G90 G64
N20 T1 D1 M6
N30 S8000 M3
N40 TRAORI
N50 ORIWKS ORIVECT
N60 G0 X0 Y0 Z60 C3=1
N70 G1 Z2 F2000
N80 X40 A3=0.5 C3=1
N90 Y30 A3=0.5 B3=0.5 C3=1 ; </script> changes nothing
N100 A3=-0.5 B3=0.5 C3=1 F3000
N110 G2 X20 Y10 CR=40 B3=-0.3 C3=1 F2000
N120 G1 X30 B3=0.4 C3=1
N130 G0 Z80 C3=1
N140 TRAFOOF
N150 M30
`;
