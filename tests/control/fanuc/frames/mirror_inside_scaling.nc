%
O0001
(rule: F 3.7 no G51.1 and no G50.1 while G51 acts)
(expect: to X1 Y0)
(expect: alarm  K5234 at 8:1)
G90G0X1.Y0
G51X0Y0P2000
G51.1X0
M30
%
