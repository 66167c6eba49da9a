%
O0001
(rule: F 4.8 G41 works in the tilted plane, and so do corners and the arc of G39)
(machine: five-axis)
(expect: to X10 Y-17.3205 Z-10)
(expect: to X10 Y-4.3301 Z-2.5)
(expect: to X42 Y-4.3301 Z-2.5)
(expect: to X55 Y6.9282 Z4)
(expect: to X55 Y34.6410 Z20)
(expect: to X50 Y38.9711 Z22.5)
(expect: to X10 Y38.9711 Z22.5)
(expect: to X-10 Y51.9615 Z30)
G10L12P1R5.
T1M06
S1000M03
G68.2X10.Y0Z0I0J30.K0
G00X0Y-20.Z0
G42D1G01X0Y0F100.
X40.,R8.
Y40.
G39
X0
G40X-20.Y60.
M30
%
