%
O0001
(rule: F 5.2 G86 G76 G87 under M4: no alarm; the spindle turns clockwise behind them)
(expect: path Z20 X10 Z2 z-5f60 Z20 X20 Z2 z-5 X21 Z2 Z20 X20 X30 X31 Z-15 X30 z-2 X31 Z20 X30)
G00X0Y0Z20.S1000M4
G98G86X10.Z-5.R2.F60
G80
M4
G76X20.Z-5.R2.Q1.
G80
M4
G87X30.Z-2.R-15.Q1.
G80
M30
%
