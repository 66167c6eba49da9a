%
O0131
(rule: F 3.7: increments behind G68 turn about the tool, G68 R alone about where it stands)
(expect: path X8.66Y5 X3.66Y13.66 X20Y10 X0Y0 x7.071y7.071f100 x0y0)
G17G90G54G0X0Y0
G68X20.Y10.R30.
G91X10.
Y10.
G90X20.Y10.
G69
G90X0Y0
G68R45.
G1X10.F100.
G69X0Y0
M30
%
