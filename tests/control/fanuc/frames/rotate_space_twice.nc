%
O0001
(rule: F 3.7 a second G68 in space turns the turned system; the tool's length lies along its Z)
(expect: to X0 Y0 Z0)
(expect: to X0 Y0 Z0)
(expect: to X0 Y-10 Z0)
(expect: to X0 Y-10 Z-20)
(expect: to X0 Y-10 Z-20)
(expect: to X0 Y0 Z10)
(expect: #1=-30)
(expect: #2=-60)
(expect: #3=-10)
G10L10P2R50.
G90G54G00X0Y0Z0
G68X0Y0Z10.I1.J0K0R90.
G68X0Y0Z0I0J0K1.R90.
G43H2
G00Z10.
X-30.
#1=#5001
#2=#5022
G49
#3=#5022
G69
G90X0Y0Z10.
M30
%
